"""The meshes of a scene, read once: their bounds and their text."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np

from vitrail.geometry.bounds import Bounds, bounds_of
from vitrail.geometry.mesh_file import MeshFileError, Triangles
from vitrail.geometry.mesh_of import solid_of
from vitrail.geometry.mesh_solid import MeshSolid
from vitrail.geometry.placement import Placed, place
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.text.sdl import Part, Table, statement, vector
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Mesh, Object, Scene

Meshes = Mapping[str, Triangles]
"""Object name to its triangles, for the objects that are meshes."""


def meshes_of(scene: Scene, refusals: Refusals) -> Meshes:
    """Every mesh of a scene with full paths, in the world; raises NotTranslatable for files that cannot be read."""
    found: dict[str, Triangles] = {}
    refused: list[Diagnostic] = []
    for index, item in enumerate(scene.objects):
        placed = place(item)
        if not isinstance(placed.shape, Mesh):
            continue
        try:
            solid = solid_of(placed)
            assert solid is not None, "a mesh is named by its full path here"
            found[item.name] = solid.triangles
        except MeshFileError as error:
            what = f"the mesh is of no use to POV-Ray: {error}"
            refused.append(refusals.at(what, "write it again as PLY or OBJ", "objects", index, "mesh"))
    if refused:
        raise NotTranslatable(refused)
    return found


def bounds_with(meshes: Meshes, item: Object) -> Bounds:
    """The room an object takes, a mesh by its vertices."""
    return bounds_of_mesh(meshes[item.name]) if item.name in meshes else bounds_of(item)


def bounds_of_mesh(mesh: Triangles) -> Bounds:
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    return Bounds((low[0], low[1], low[2]), (high[0], high[1], high[2]))


def mesh_parts(placed: Placed, units: Normalisation) -> tuple[Part, ...]:
    """The parts of a ``mesh2``: vertices, normals, faces, and a direction that makes it a solid."""
    solid = solid_of(placed)
    assert solid is not None, "a mesh is named by its full path here"
    return _parts(solid, units)


@lru_cache(maxsize=16)
def _parts(solid: MeshSolid, units: Normalisation) -> tuple[Part, ...]:
    """Made once for all runs."""
    mesh = solid.triangles
    points = _table("vertex_vectors", (mesh.vertices - np.array(units.centre)) * units.scale)
    normals = () if mesh.normals is None else (_table("normal_vectors", mesh.normals),)
    # Any direction will do that no edge is along.
    inside = statement("inside_vector", vector((0.618, 0.755, 0.213)))
    return (points, *normals, _table("face_indices", mesh.faces), inside)


def _table(word: str, rows: np.ndarray) -> Table:
    return Table(word, tuple(map(tuple, rows.tolist())))
