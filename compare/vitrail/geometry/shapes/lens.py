"""A lens about its own z axis: two spherical or flat faces and a cylindrical rim; the front face is the one at -z."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from vitrail.base.fault import Fault
from vitrail.base.vector import Vec, scale
from vitrail.geometry.bounds import Bounds, around
from vitrail.geometry.face import Face, flat_face, round_face, tube_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import AXES, rim
from vitrail.geometry.solid import Ball, Solid
from vitrail.scene.model import Lens


@dataclass(frozen=True, eq=False)
class PlacedLens(Solid):
    """A lens in its frame."""

    shape: Lens

    def moved(self, frame: Frame) -> PlacedLens:
        return PlacedLens(self.shape, frame)

    def grown(self, by_m: float) -> PlacedLens | None:
        """Scaled about its middle until it is thicker by that much on both sides."""
        factor = 1 + 2 * by_m / self.thickness_m
        lengths = ("radius_front", "radius_back", "thickness", "diameter")
        return self._with(**{key: getattr(self.shape, key) * factor for key in lengths})

    @property
    def bounds(self) -> Bounds:
        """Half the depth is that at the axis, or at the rim where a concave face reaches farther out."""
        half, radii = self.shape.diameter / 2, (self.shape.radius_front, self.shape.radius_back)
        depth = self.shape.thickness / 2 + max(0.0, *(-sagitta(radius, half) for radius in radii))
        box = Bounds((-half, -half, -depth), (half, half, depth))
        return around(self.frame.point(corner) for corner in box.corners)

    @property
    def ball(self) -> Ball:
        half = self.shape.diameter / 2
        has_hollow = min(self.shape.radius_front, self.shape.radius_back) < 0
        depth = self.shape.thickness / 2 + (half if has_hollow else 0)
        return np.array(self.frame.origin), float(np.hypot(half, depth))

    def depth(self, points: np.ndarray) -> np.ndarray:
        """Depth between the two faces and inside the rim."""
        local, shape = self.frame.local_points(points), self.shape
        edge = shape.diameter / 2 - np.hypot(local[:, 0], local[:, 1])
        front = _depth_behind(local, shape.radius_front, -shape.thickness / 2, -1.0)
        back = _depth_behind(local, shape.radius_back, shape.thickness / 2, 1.0)
        return np.minimum(edge, np.minimum(front, back))

    def surface_points(self, towards: Solid) -> list[Vec]:
        half = self.shape.thickness / 2
        vertices: list[Vec] = [(0.0, 0.0, -half), (0.0, 0.0, half)]
        edge = rim((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), self.shape.diameter / 2)[1:]
        return [self.frame.point(point) for point in [*vertices, *edge]]

    def directions_from(self, point: Vec) -> list[Vec]:
        return [self.frame.direction(axis) for axis in AXES]

    @property
    def thickness_m(self) -> float:
        return min(self.shape.thickness, self.shape.diameter)

    @property
    def faces(self) -> list[Face]:
        frame, shape = self.frame, self.shape
        axis = frame.direction((0.0, 0.0, 1.0))
        found = [tube_face(axis, frame.origin, shape.diameter / 2)]
        for side, radius in ((-1.0, shape.radius_front), (1.0, shape.radius_back)):
            vertex = side * shape.thickness / 2
            if radius == 0:
                found.append(flat_face(scale(axis, side), frame.point((0.0, 0.0, vertex))))
            else:
                found.append(round_face(frame.point((0.0, 0.0, vertex - side * radius)), radius))
        return found

    @property
    def is_convex_or_flat(self) -> bool:
        return self.shape.radius_front >= 0 and self.shape.radius_back >= 0

    @property
    def curvature_radius_m(self) -> float | None:
        radii = (self.shape.radius_front, self.shape.radius_back)
        return min((abs(radius) for radius in radii if radius), default=None)

    def faults(self) -> Iterator[Fault]:
        """The rim must fit on both spheres, and the faces may not cross inside it."""
        shape, half = self.shape, self.shape.diameter / 2
        for key in ("radius_front", "radius_back"):
            radius = abs(getattr(shape, key))
            if 0 < radius < half:
                what = f"a face of radius {radius:g} m cannot be {shape.diameter:g} m wide"
                yield Fault(what, f"lower `diameter` to at most {2 * radius:g}, or raise `{key}`", (key,))
                return
        edge = shape.thickness - sagitta(shape.radius_front, half) - sagitta(shape.radius_back, half)
        if edge < 0:
            what = f"the faces cross before the rim, where the thickness would be {edge:.4g} m"
            remedy = f"raise `thickness` to at least {shape.thickness - edge:.6g}, or lower `diameter`"
            yield Fault(what, remedy, ("thickness",))


def sagitta(radius: float, half_width: float) -> float:
    """How far a face has dropped from its vertex at ``half_width``; 0 if flat (radius 0), negative if concave.

    A face cannot be wider than its sphere.
    """
    if radius == 0:
        return 0.0
    size = abs(radius)
    reach = min(half_width, size)
    return math.copysign(reach * reach / (size + math.sqrt(max(0.0, (size - reach) * (size + reach)))), radius)


def _depth_behind(points: np.ndarray, radius: float, vertex: float, outward: float) -> np.ndarray:
    """Depth behind one face with its vertex on the axis; ``outward`` is the sign of z that points out of the glass."""
    if radius == 0:
        return outward * (vertex - points[:, 2])
    center = np.array([0.0, 0.0, vertex - outward * radius])
    distance = np.linalg.norm(points - center, axis=1)
    if radius > 0:
        return radius - distance
    # A concave face is taken from the glass as the near half of its ball; what lies beyond that is outside too.
    return np.minimum(distance + radius, outward * (center[2] - points[:, 2]))
