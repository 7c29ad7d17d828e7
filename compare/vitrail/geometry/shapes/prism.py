"""A polygon in x, y, convex or not, extruded along its own z."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from vitrail.base.fault import Fault
from vitrail.base.vector import Vec
from vitrail.geometry.bounds import Bounds, around
from vitrail.geometry.face import Face, flat_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import AXES
from vitrail.geometry.shapes.box import ball_around
from vitrail.geometry.shapes.polygon import depth_in_polygon, edges_of, polygon_fault, turns_left
from vitrail.geometry.solid import Ball, Solid
from vitrail.scene.model import Prism

MOST_CORNERS = 1000


@dataclass(frozen=True, eq=False)
class PlacedPrism(Solid):
    """A prism in its frame."""

    shape: Prism

    def moved(self, frame: Frame) -> PlacedPrism:
        return PlacedPrism(self.shape, frame)

    def grown(self, by_m: float) -> PlacedPrism | None:
        """Scaled about its middle until it is thicker by that much on both sides."""
        corners, factor = self.shape.corners, 1 + 2 * by_m / self.thickness_m
        x, y = (sum(corner[axis] for corner in corners) / len(corners) for axis in (0, 1))
        profile = tuple(((a - x) * factor + x, (b - y) * factor + y) for a, b in corners)
        return self._with(height=self.shape.height * factor, profile=profile, apex_deg=None, side=None)

    @property
    def _ends(self) -> list[Vec]:
        """The corners of both ends in the world."""
        half = self.shape.height / 2
        return [self.frame.point((x, y, z)) for x, y in self.shape.corners for z in (-half, half)]

    @property
    def bounds(self) -> Bounds:
        return around(self._ends)

    @property
    def ball(self) -> Ball:
        return ball_around(np.array(self._ends))

    def depth(self, points: np.ndarray) -> np.ndarray:
        local = self.frame.local_points(points)
        across = depth_in_polygon(local[:, :2], np.array(self.shape.corners))
        return np.minimum(self.shape.height / 2 - np.abs(local[:, 2]), across)

    def surface_points(self, towards: Solid) -> list[Vec]:
        """Corners and middles of the edges, at both ends and half way."""
        outline = []
        for a, b in edges_of(self.shape.corners):
            outline += [a, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)]
        half = self.shape.height / 2
        return [self.frame.point((x, y, z)) for x, y in outline for z in (-half, 0.0, half)]

    def directions_from(self, point: Vec) -> list[Vec]:
        return [self.frame.direction(axis) for axis in AXES]

    @property
    def thickness_m(self) -> float:
        return min(self.shape.height, *(math.dist(a, b) for a, b in edges_of(self.shape.corners)))

    @property
    def faces(self) -> list[Face]:
        frame, half = self.frame, self.shape.height / 2
        sides = [
            flat_face(frame.direction((b[1] - a[1], a[0] - b[0], 0.0)), frame.point((a[0], a[1], 0.0)))
            for a, b in edges_of(self.shape.corners)
        ]
        ends = [flat_face(frame.direction((0.0, 0.0, z)), frame.point((0.0, 0.0, z * half))) for z in (-1.0, 1.0)]
        return [*sides, *ends]

    @property
    def is_convex_or_flat(self) -> bool:
        return turns_left(self.shape.corners)

    @property
    def curvature_radius_m(self) -> None:
        return None

    def faults(self) -> Iterator[Fault]:
        """A profile's edges may meet only where they follow each other, and it must enclose an area."""
        corners = self.shape.profile
        if corners is None:
            return
        if len(corners) > MOST_CORNERS:
            remedy = f"use at most {MOST_CORNERS}, or a mesh"
            yield Fault(f"the profile has {len(corners)} corners", remedy, ("profile",))
        elif (fault := polygon_fault(corners)) is not None:
            yield Fault(fault.what, fault.remedy, ("profile",))
