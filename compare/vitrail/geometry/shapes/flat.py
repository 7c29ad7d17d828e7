"""The flat family: plane, rectangle and disc. A plane is the surface of the half space below its normal."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from vitrail.base.changed import unchecked
from vitrail.base.vector import Vec, add, cross, dot, length, scale, subtract, unit
from vitrail.geometry.bounds import EVERYWHERE, Bounds, about_disc, about_parallelogram
from vitrail.geometry.face import Face, flat_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import STEPS, both_ways, rim
from vitrail.geometry.solid import Solid
from vitrail.geometry.surface import SurfaceFrame, tangents
from vitrail.scene.model import Disc, Plane, Rectangle


class FlatSolid(Solid):
    """What all flat shapes answer alike."""

    def grown(self, by_m: float) -> None:
        return None

    @property
    def ball(self) -> None:
        return None

    @property
    def thickness_m(self) -> float:
        return math.inf

    @property
    def is_convex_or_flat(self) -> bool:
        return True

    @property
    def curvature_radius_m(self) -> None:
        return None


@dataclass(frozen=True, eq=False)
class PlacedPlane(FlatSolid):
    """An infinite plane, and the half space below it."""

    shape: Plane

    def moved(self, frame: Frame) -> PlacedPlane:
        point, normal = frame.point(self.shape.point), frame.direction(self.shape.normal)
        return PlacedPlane(unchecked(self.shape, point=point, normal=normal), Frame())

    def turned(self) -> PlacedPlane:
        """The same plane as the surface of the half space on its other side."""
        x, y, z = self.shape.normal
        return PlacedPlane(unchecked(self.shape, normal=(-x, -y, -z)), self.frame)

    @property
    def bounds(self) -> Bounds:
        return EVERYWHERE

    def depth(self, points: np.ndarray) -> np.ndarray:
        normal = np.asarray(self.shape.normal) / np.linalg.norm(self.shape.normal)
        return -(np.asarray(points, float) - self.shape.point) @ normal

    def surface_points(self, towards: Solid) -> list[Vec]:
        """None: those of the other solid are asked."""
        return []

    def directions_from(self, point: Vec) -> list[Vec]:
        return both_ways(self.shape.normal)

    @property
    def faces(self) -> list[Face]:
        return [flat_face(self.shape.normal, self.shape.point)]

    @property
    def carrier(self) -> Plane:
        return self.shape

    @property
    def surface_frame(self) -> SurfaceFrame:
        u, v = tangents(self.shape.normal)
        return SurfaceFrame(self.shape.point, u, v, unit(self.shape.normal))

    @property
    def number_size_m(self) -> float:
        return float(np.linalg.norm(self.shape.point))


class OpenFlat(FlatSolid):
    """A flat shape with an edge, which encloses nothing."""

    def depth(self, points: np.ndarray) -> np.ndarray:
        return np.full(len(points), -np.inf)

    @property
    def faces(self) -> list[Face]:
        return []

    @property
    def is_closed(self) -> bool:
        return False


@dataclass(frozen=True, eq=False)
class PlacedRectangle(OpenFlat):
    """A rectangle with its center and half edges in the world."""

    shape: Rectangle

    def moved(self, frame: Frame) -> PlacedRectangle:
        update = {
            "center": frame.point(self.shape.center),
            "u": frame.direction(self.shape.u),
            "v": frame.direction(self.shape.v),
        }
        return PlacedRectangle(unchecked(self.shape, **update), Frame())

    @property
    def bounds(self) -> Bounds:
        return about_parallelogram(self.shape.center, self.shape.u, self.shape.v)

    def surface_points(self, towards: Solid) -> list[Vec]:
        center, u, v = self.shape.center, self.shape.u, self.shape.v
        return [add(center, add(scale(u, a), scale(v, b))) for a, b in product(STEPS, STEPS)]

    def directions_from(self, point: Vec) -> list[Vec]:
        return both_ways(cross(self.shape.u, self.shape.v))

    @property
    def carrier(self) -> Plane:
        return Plane(point=self.shape.center, normal=cross(self.shape.u, self.shape.v))

    @property
    def surface_frame(self) -> SurfaceFrame:
        u, v = unit(self.shape.u), unit(self.shape.v)
        return SurfaceFrame(self.shape.center, u, v, cross(u, v))

    def distances(self, points: Sequence[Vec]) -> list[float]:
        return [self._distance(point) for point in points]

    def _distance(self, point: Vec) -> float:
        """How far a point is beyond the edges along u and along v, and above the plane."""
        away, u, v = subtract(point, self.shape.center), unit(self.shape.u), unit(self.shape.v)
        beyond_u = max(0.0, abs(dot(away, u)) - length(self.shape.u))
        beyond_v = max(0.0, abs(dot(away, v)) - length(self.shape.v))
        return length((beyond_u, beyond_v, dot(away, unit(cross(u, v)))))


@dataclass(frozen=True, eq=False)
class PlacedDisc(OpenFlat):
    """A disc with its center and normal in the world."""

    shape: Disc

    def moved(self, frame: Frame) -> PlacedDisc:
        center, normal = frame.point(self.shape.center), frame.direction(self.shape.normal)
        return PlacedDisc(unchecked(self.shape, center=center, normal=normal), Frame())

    @property
    def bounds(self) -> Bounds:
        return about_disc(self.shape.center, self.shape.normal, self.shape.radius)

    def surface_points(self, towards: Solid) -> list[Vec]:
        return rim(self.shape.center, self.shape.normal, self.shape.radius)

    def directions_from(self, point: Vec) -> list[Vec]:
        return both_ways(self.shape.normal)

    @property
    def carrier(self) -> Plane:
        return Plane(point=self.shape.center, normal=self.shape.normal)

    @property
    def surface_frame(self) -> SurfaceFrame:
        u, v = tangents(self.shape.normal)
        return SurfaceFrame(self.shape.center, u, v, unit(self.shape.normal))

    def distances(self, points: Sequence[Vec]) -> list[float]:
        return [self._distance(point) for point in points]

    def _distance(self, point: Vec) -> float:
        """How far a point is beyond the rim, and above the plane."""
        away, normal = subtract(point, self.shape.center), unit(self.shape.normal)
        height = dot(away, normal)
        aside = length(subtract(away, scale(normal, height)))
        return length((max(0.0, aside - self.shape.radius), height, 0.0))


def plane_distance(plane: Plane, point: Vec) -> float:
    """Signed distance of a point from a plane, positive on the side of its normal."""
    return dot(unit(plane.normal), subtract(point, plane.point))
