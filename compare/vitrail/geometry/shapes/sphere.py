"""A ball."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vitrail.base.changed import unchecked
from vitrail.base.vector import Vec, add, length, scale, subtract
from vitrail.geometry.bounds import Bounds, about
from vitrail.geometry.face import Face, round_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import AXES, both_ways
from vitrail.geometry.solid import Ball, Solid
from vitrail.scene.model import Sphere


@dataclass(frozen=True, eq=False)
class PlacedSphere(Solid):
    """A ball with its center in the world."""

    shape: Sphere

    def moved(self, frame: Frame) -> PlacedSphere:
        return PlacedSphere(unchecked(self.shape, center=frame.point(self.shape.center)), Frame())

    def grown(self, by_m: float) -> PlacedSphere | None:
        return self._with(radius=self.shape.radius + by_m)

    @property
    def bounds(self) -> Bounds:
        return about(self.shape.center, (self.shape.radius,) * 3)

    @property
    def ball(self) -> Ball:
        return np.array(self.shape.center), self.shape.radius

    def depth(self, points: np.ndarray) -> np.ndarray:
        return self.shape.radius - np.linalg.norm(np.asarray(points, float) - self.shape.center, axis=1)

    def surface_points(self, towards: Solid) -> list[Vec]:
        """The ends of the axes, and what faces the other solid."""
        center, radius = self.shape.center, self.shape.radius
        directions = [*AXES, *towards.directions_from(center)]
        return [add(center, scale(direction, radius / length(direction))) for direction in directions]

    def directions_from(self, point: Vec) -> list[Vec]:
        away = subtract(self.shape.center, point)
        return both_ways(away) if length(away) > 0 else []

    @property
    def thickness_m(self) -> float:
        return 2 * self.shape.radius

    @property
    def faces(self) -> list[Face]:
        return [round_face(self.shape.center, self.shape.radius)]

    @property
    def is_convex_or_flat(self) -> bool:
        return True

    @property
    def curvature_radius_m(self) -> float:
        return self.shape.radius
