"""A box along its own axes."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np

from vitrail.base.vector import Vec, add, scale, subtract
from vitrail.geometry.bounds import Bounds, around
from vitrail.geometry.face import Face, flat_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import AXES, STEPS
from vitrail.geometry.solid import Ball, Solid
from vitrail.scene.model import Box

_AXES: tuple[Vec, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True, eq=False)
class PlacedBox(Solid):
    """A box in its frame."""

    shape: Box

    def moved(self, frame: Frame) -> PlacedBox:
        return PlacedBox(self.shape, frame)

    def grown(self, by_m: float) -> PlacedBox | None:
        margin = (by_m, by_m, by_m)
        return self._with(min=subtract(self.shape.min, margin), max=add(self.shape.max, margin))

    @property
    def corners(self) -> np.ndarray:
        """Its eight corners in the world, (8, 3)."""
        return np.array([self.frame.point(corner) for corner in Bounds(self.shape.min, self.shape.max).corners])

    @property
    def bounds(self) -> Bounds:
        return around(self.frame.point(corner) for corner in Bounds(self.shape.min, self.shape.max).corners)

    @property
    def ball(self) -> Ball:
        return ball_around(self.corners)

    def depth(self, points: np.ndarray) -> np.ndarray:
        local = self.frame.local_points(points)
        return np.minimum(local - self.shape.min, np.subtract(self.shape.max, local)).min(axis=1)

    def surface_points(self, towards: Solid) -> list[Vec]:
        """A grid on the six faces."""
        middle = scale(add(self.shape.min, self.shape.max), 0.5)
        half = scale(subtract(self.shape.max, self.shape.min), 0.5)
        return [
            self.frame.point(add(middle, (a * half[0], b * half[1], c * half[2])))
            for a, b, c in product(STEPS, STEPS, STEPS)
            if 1.0 in (abs(a), abs(b), abs(c))
        ]

    def directions_from(self, point: Vec) -> list[Vec]:
        return [self.frame.direction(axis) for axis in AXES]

    @property
    def thickness_m(self) -> float:
        return min(high - low for low, high in zip(self.shape.min, self.shape.max, strict=True))

    @property
    def faces(self) -> list[Face]:
        ends = [(axis, self.shape.max) for axis in _AXES] + [(scale(axis, -1), self.shape.min) for axis in _AXES]
        return [flat_face(self.frame.direction(axis), self.frame.point(corner)) for axis, corner in ends]

    @property
    def is_convex_or_flat(self) -> bool:
        return True

    @property
    def curvature_radius_m(self) -> None:
        return None


def ball_around(points: np.ndarray) -> Ball:
    """A sphere around points (n, 3), about the middle of their box."""
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    return center, float(np.linalg.norm(points - center, axis=1).max())
