"""A ring torus: a tube around a circle."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from vitrail.base.changed import changed, unchecked
from vitrail.base.vector import Vec, add, scale, subtract, unit
from vitrail.geometry.bounds import Bounds, about, about_disc
from vitrail.geometry.face import Face, torus_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import both_ways, rim
from vitrail.geometry.solid import Ball, Solid
from vitrail.geometry.surface import tangents
from vitrail.scene.model import Torus


@dataclass(frozen=True, eq=False)
class PlacedTorus(Solid):
    """A torus with its center and its axis in the world."""

    shape: Torus

    def moved(self, frame: Frame) -> PlacedTorus:
        center, normal = frame.point(self.shape.center), frame.direction(self.shape.normal)
        return PlacedTorus(unchecked(self.shape, center=center, normal=normal), Frame())

    def grown(self, by_m: float) -> PlacedTorus:
        """A thicker tube around the same circle, which is exactly the surface at that distance."""
        return PlacedTorus(changed(self.shape, radius_tube=self.shape.radius_tube + by_m), self.frame)

    @property
    def bounds(self) -> Bounds:
        circle = about_disc(self.shape.center, self.shape.normal, self.shape.radius)
        reach = subtract(circle.high, self.shape.center)
        return about(self.shape.center, add(reach, (self.shape.radius_tube,) * 3))

    @property
    def ball(self) -> Ball:
        return np.array(self.shape.center), self.shape.radius + self.shape.radius_tube

    def depth(self, points: np.ndarray) -> np.ndarray:
        """The radius of the tube less the distance from the circle: exact."""
        offset, axis = np.asarray(points, float) - self.shape.center, np.array(unit(self.shape.normal))
        height = offset @ axis
        from_ring = np.linalg.norm(offset - np.outer(height, axis), axis=1) - self.shape.radius
        return self.shape.radius_tube - np.hypot(from_ring, height)

    def surface_points(self, towards: Solid) -> list[Vec]:
        """Four around the tube at places around the circle, and those that face the other solid there."""
        center, axis, tube = self.shape.center, unit(self.shape.normal), self.shape.radius_tube
        found = []
        for middle in rim(center, axis, self.shape.radius)[1:]:
            outward = unit(subtract(middle, center))
            directions = [*both_ways(axis), *both_ways(outward), *towards.directions_from(middle)]
            found += [add(middle, scale(unit(each), tube)) for each in directions if any(each)]
        return found

    def directions_from(self, point: Vec) -> list[Vec]:
        """To the nearest point of the circle, and along the axis, as a tube that lies on a plane is met."""
        axis = unit(self.shape.normal)
        away = subtract(point, self.shape.center)
        height = math.fsum(a * b for a, b in zip(away, axis, strict=True))
        aside = subtract(away, scale(axis, height))
        outward = unit(aside) if any(aside) else tangents(axis)[0]
        nearest = add(self.shape.center, scale(outward, self.shape.radius))
        return [*both_ways(axis), *both_ways(subtract(nearest, point))]

    @property
    def thickness_m(self) -> float:
        return 2 * self.shape.radius_tube

    @property
    def faces(self) -> list[Face]:
        return [torus_face(unit(self.shape.normal), self.shape.center, self.shape.radius, self.shape.radius_tube)]

    @property
    def is_convex_or_flat(self) -> bool:
        return False

    @property
    def curvature_radius_m(self) -> float:
        return self.shape.radius_tube
