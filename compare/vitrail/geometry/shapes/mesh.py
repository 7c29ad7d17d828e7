"""A mesh from a file beside the scene, read when it is first asked about, once for a world."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from vitrail.base.fault import Fault
from vitrail.base.vector import Vec
from vitrail.geometry.bounds import EVERYWHERE, Bounds
from vitrail.geometry.face import Face
from vitrail.geometry.frame import Frame
from vitrail.geometry.mesh_file import ReadMesh, placed, read_mesh
from vitrail.geometry.solid import Solid
from vitrail.scene.model import Mesh

if TYPE_CHECKING:
    from vitrail.geometry.mesh_solid import MeshSolid

ENDINGS = (".ply", ".obj")


@dataclass(frozen=True, eq=False)
class PlacedMesh(Solid):
    """A mesh in its frame. Without a ``file`` with a full path it is not read, and nothing is known of it.

    ``outwards_m`` is how far its faces have been moved along their normals; ``origin`` is the mesh before that.
    """

    shape: Mesh
    file: Path | None = None
    outwards_m: float = 0.0
    origin: PlacedMesh | None = None

    @cached_property
    def solid(self) -> MeshSolid | None:
        """What the mesh encloses; None if it is not read. Raises MeshFileError for a file that cannot be read."""
        from vitrail.geometry.mesh_solid import MeshSolid

        if self.origin is not None:
            read = self.origin.solid
            return read if read is None or self.outwards_m == 0 else MeshSolid(read.moved(self.outwards_m))
        return None if self.file is None else MeshSolid(placed(self.read, self.shape, self.frame))

    @property
    def read(self) -> ReadMesh:
        """What its file holds, in the axes of the file. Raises MeshFileError for a file that cannot be read."""
        assert self.file is not None, "a mesh of a world with a folder has a full path"
        return read_mesh(self.file, is_smooth=self.shape.smooth)

    @property
    def known(self) -> MeshSolid:
        """What the mesh encloses, where it must be known."""
        assert self.solid is not None, "a mesh of a world with a folder has a full path"
        return self.solid

    def moved(self, frame: Frame) -> PlacedMesh:
        return PlacedMesh(self.shape, frame, self.file)

    def grown(self, by_m: float) -> PlacedMesh:
        return PlacedMesh(self.shape, self.frame, self.file, self.outwards_m + by_m, self.origin or self)

    @property
    def bounds(self) -> Bounds:
        """Infinite: a plan is made without its file. ``vertex_bounds`` has read it."""
        return EVERYWHERE

    @property
    def vertex_bounds(self) -> Bounds:
        """The box around its vertices as the file has them."""
        vertices = (self.origin or self).known.triangles.vertices
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        return Bounds((low[0], low[1], low[2]), (high[0], high[1], high[2]))

    @property
    def ball(self) -> None:
        return None

    @property
    def number_size_m(self) -> float:
        if self.solid is None:
            return 0.0
        return float(np.abs(self.solid.triangles.vertices).max()) + self.solid.size

    def depth(self, points: np.ndarray) -> np.ndarray:
        return np.full(len(points), -np.inf) if self.solid is None else self.solid.depth(points)

    def is_inside(self, points: np.ndarray) -> np.ndarray:
        """Cheaper than how deep."""
        return np.zeros(len(points), bool) if self.solid is None else self.solid.winding(points) > 0

    def distances(self, points: Sequence[Vec]) -> list[float]:
        if self.solid is None or not points:
            return [math.inf] * len(points)
        return [float(each) for each in self.solid.distance(np.array(points, float))]

    def surface_points(self, towards: Solid) -> list[Vec]:
        return [] if self.solid is None else [(x, y, z) for x, y, z in self.solid.surface_points().tolist()]

    def directions_from(self, point: Vec) -> list[Vec]:
        return []

    @property
    def thickness_m(self) -> float:
        """That of the walls under some of its faces."""
        return math.inf if self.solid is None else self.solid.thickness()

    @property
    def faces(self) -> list[Face]:
        return []

    @property
    def is_convex_or_flat(self) -> bool:
        """Not looked at: a mesh counts as hollow."""
        return False

    @property
    def curvature_radius_m(self) -> None:
        return None

    def faults(self) -> Iterator[Fault]:
        """Its file must be there; what the file holds is a matter of ``check.meshes``."""
        name = self.shape.file
        if Path(name).suffix.lower() not in ENDINGS:
            remedy = "give a file that ends in .ply or .obj"
            yield Fault(f"`{name}` is neither PLY nor OBJ", remedy, ("file",))
