"""The meshes of a scene, read once: their bounds and their text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from vitrail.lower.povray.mesh_file import MeshFileError, Triangles, read_triangles
from vitrail.lower.povray.normalise import Normalisation
from vitrail.lower.povray.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.sdl import number, vector
from vitrail.plan.bounds import Bounds, bounds_of
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Mesh, Object, Scene
from vitrail.scene.placement import place

Meshes = Mapping[str, Triangles]
"""Object name to its triangles, for the objects that are meshes."""


def meshes_of(scene: Scene, folder: Path, refusals: Refusals) -> Meshes:
    """Every mesh of the scene, in the world; raises NotTranslatable for files that cannot be read."""
    found: dict[str, Triangles] = {}
    refused: list[Diagnostic] = []
    for index, item in enumerate(scene.objects):
        placed = place(item)
        if not isinstance(placed.shape, Mesh):
            continue
        try:
            found[item.name] = read_triangles(folder / placed.shape.file, placed.shape, placed.frame)
        except MeshFileError as error:
            what = f"the mesh is of no use to POV-Ray: {error}"
            refused.append(refusals.at(what, "write it again as PLY or OBJ", "objects", index, "mesh"))
    if refused:
        raise NotTranslatable(refused)
    return found


def bounds_with(meshes: Meshes, item: Object) -> Bounds:
    """The room an object takes, a mesh by its vertices."""
    return meshes[item.name].bounds if item.name in meshes else bounds_of(item)


def mesh_parts(mesh: Triangles, units: Normalisation) -> Iterator[str]:
    """The parts of a ``mesh2``: vertices, normals, faces, and a direction that makes it a solid."""
    points = (mesh.vertices - np.array(units.centre)) * units.scale
    yield _vectors("vertex_vectors", points)
    if mesh.normals is not None:
        yield _vectors("normal_vectors", mesh.normals)
    rows = ",\n".join(f"<{a}, {b}, {c}>" for a, b, c in mesh.faces.tolist())
    yield f"face_indices {{ {len(mesh.faces)},\n{rows} }}"
    # Any direction will do that no edge is along.
    yield f"inside_vector <{number(0.618)}, {number(0.755)}, {number(0.213)}>"


def _vectors(word: str, rows: np.ndarray) -> str:
    text = ",\n".join(vector(row) for row in rows.tolist())
    return f"{word} {{ {len(rows)},\n{text} }}"
