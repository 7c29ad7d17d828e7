"""The meshes of a scene: refused where they cannot be read, their room, and their text."""

from __future__ import annotations

import numpy as np

from vitrail.geometry.bounds import Bounds
from vitrail.geometry.mesh_file import MeshFileError
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.text.sdl import Part, Table, statement, vector
from vitrail.scene.diagnostic import Diagnostic


def refuse_unreadable_meshes(world: World, refusals: Refusals) -> None:
    """Read every mesh of a world with a folder; raises NotTranslatable for files that cannot be read."""
    refused: list[Diagnostic] = []
    for index, solid in enumerate(world.solids):
        if isinstance(solid, PlacedMesh):
            try:
                solid.known  # noqa: B018 - reads the file
            except MeshFileError as error:
                what = f"the mesh is of no use to POV-Ray: {error}"
                refused.append(refusals.at(what, "write it again as PLY or OBJ", "objects", index, "mesh"))
    if refused:
        raise NotTranslatable(refused)


def room_of(solid: Solid) -> Bounds:
    """The room a solid takes, a mesh by its vertices."""
    return solid.vertex_bounds if isinstance(solid, PlacedMesh) else solid.bounds


def mesh_parts(placed: PlacedMesh, units: Normalisation) -> tuple[Part, ...]:
    """The parts of a ``mesh2``: vertices, normals, faces, and a direction that makes it a solid.

    POV-Ray's world is left-handed: it sees the outside of a triangle where its corners go clockwise.
    """
    mesh = placed.known.triangles
    points = _table("vertex_vectors", (mesh.vertices - np.array(units.centre)) * units.scale)
    normals = () if mesh.normals is None else (_table("normal_vectors", mesh.normals),)
    # Any direction will do that no edge is along.
    inside = statement("inside_vector", vector((0.618, 0.755, 0.213)))
    return (points, *normals, _table("face_indices", mesh.faces[:, ::-1]), inside)


def _table(word: str, rows: np.ndarray) -> Table:
    return Table(word, tuple(map(tuple, rows.tolist())))
