"""A polygon turned about its own y axis: pieces of cones, cylinders and flat rings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vitrail.base.changed import changed
from vitrail.base.fault import Fault
from vitrail.base.vector import Vec, scale
from vitrail.geometry.bounds import Bounds, about_disc, together
from vitrail.geometry.face import Face, cone_face, flat_face, tube_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import AXES, rim
from vitrail.geometry.shapes.polygon import (
    Corner,
    distance_to_edge,
    edges_of,
    is_crossed,
    polygon_fault,
    turns_left,
)
from vitrail.geometry.solid import Ball, Solid
from vitrail.scene.model import Lathe

MOST_CORNERS = 1000


@dataclass(frozen=True, eq=False)
class PlacedLathe(Solid):
    """A lathe in its frame."""

    shape: Lathe

    @cached_property
    def corners(self) -> list[Corner]:
        """The profile counter-clockwise: the solid lies on its left."""
        corners = [(float(radius), float(height)) for radius, height in self.shape.profile]
        area = sum(a[0] * b[1] - b[0] * a[1] for a, b in edges_of(corners))
        return corners if area > 0 else corners[::-1]

    @property
    def walls(self) -> list[tuple[Corner, Corner]]:
        """The pieces that have a surface: all but those on the axis."""
        return [(a, b) for a, b in edges_of(self.corners) if a[0] > 0 or b[0] > 0]

    def moved(self, frame: Frame) -> PlacedLathe:
        return PlacedLathe(self.shape, frame)

    def grown(self, by_m: float) -> PlacedLathe:
        """Every wall moved along its normal; corners on the axis stay there."""
        edges = edges_of(self.corners)
        normals = [_normal(a, b) if a[0] > 0 or b[0] > 0 else None for a, b in edges]
        profile = tuple(
            _mitred(corner, normals[index - 1], normals[index], by_m) for index, corner in enumerate(self.corners)
        )
        return PlacedLathe(changed(self.shape, profile=profile), self.frame)

    @property
    def axis(self) -> Vec:
        return self.frame.direction((0.0, 1.0, 0.0))

    def _on_axis(self, height: float) -> Vec:
        return self.frame.point((0.0, height, 0.0))

    @property
    def bounds(self) -> Bounds:
        return together(about_disc(self._on_axis(height), self.axis, radius) for radius, height in self.corners)

    @property
    def ball(self) -> Ball:
        heights = [height for _, height in self.corners]
        middle = (min(heights) + max(heights)) / 2
        reach = max(math.hypot(radius, height - middle) for radius, height in self.corners)
        return np.array(self._on_axis(middle)), reach

    def depth(self, points: np.ndarray) -> np.ndarray:
        """Distance to the nearest wall in the half plane through the axis and the point: exact."""
        local = self.frame.local_points(points)
        flat = np.stack([np.hypot(local[:, 0], local[:, 2]), local[:, 1]], axis=1)
        inside = np.zeros(len(flat), bool)
        distance = np.full(len(flat), np.inf)
        for a, b in self.walls:
            first, last = np.array(a), np.array(b)
            inside ^= is_crossed(flat, first, last)
            distance = np.minimum(distance, distance_to_edge(flat, first, last))
        return np.where(inside, distance, -distance)

    def surface_points(self, towards: Solid) -> list[Vec]:
        """The circles of the corners, and those half way between them."""
        found = []
        for a, b in self.walls:
            for radius, height in (a, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)):
                circle = rim(self._on_axis(height), self.axis, radius)
                found += circle[1:] if radius > 0 else circle[:1]
        return found

    def directions_from(self, point: Vec) -> list[Vec]:
        return [self.frame.direction(axis) for axis in AXES]

    @property
    def thickness_m(self) -> float:
        """The shortest way through it, straight in from the middle of a wall."""
        outline = [*self.walls, *(((-a[0], a[1]), (-b[0], b[1])) for a, b in self.walls)]
        return min(_way_through(wall, outline) for wall in self.walls)

    @property
    def faces(self) -> list[Face]:
        return [self._face(a, b) for a, b in self.walls]

    def _face(self, a: Corner, b: Corner) -> Face:
        """A ring, a cylinder or a cone; radius or slope are below 0 where the glass is outside of the face."""
        out_radius, out_height = _normal(a, b)
        if a[1] == b[1]:
            return flat_face(scale(self.axis, out_height), self._on_axis(a[1]))
        side = 1.0 if out_radius > 0 else -1.0
        if a[0] == b[0]:
            return tube_face(self.axis, self._on_axis(0.0), side * a[0])
        slope = (b[0] - a[0]) / (b[1] - a[1])
        tip = self._on_axis(a[1] - a[0] / slope)
        return cone_face(self.axis if slope > 0 else scale(self.axis, -1.0), tip, side * abs(slope))

    @property
    def is_convex_or_flat(self) -> bool:
        """Whether the whole cross-section is convex: a ring never is, for it has a hole."""
        corners = self.corners
        if len(self.walls) == len(corners):
            return False
        start = next(i for i, (a, b) in enumerate(edges_of(corners)) if a[0] == 0 and b[0] == 0) + 1
        half = [*corners[start:], *corners[:start]]
        return turns_left([*half, *((-radius, height) for radius, height in reversed(half) if radius > 0)])

    @property
    def curvature_radius_m(self) -> float | None:
        """The smallest of its cones and cylinders, each by its wider end; None for flat rings alone."""
        return min((max(a[0], b[0]) for a, b in self.walls if a[1] != b[1]), default=None)

    def faults(self) -> Iterator[Fault]:
        """Pieces may meet only where they follow each other, and the profile must enclose an area."""
        corners = self.shape.profile
        if len(corners) > MOST_CORNERS:
            remedy = f"use at most {MOST_CORNERS}, or a mesh"
            yield Fault(f"the profile has {len(corners)} corners", remedy, ("profile",))
        elif (fault := polygon_fault(corners)) is not None:
            yield Fault(fault.what, fault.remedy, ("profile",))


def _normal(a: Corner, b: Corner) -> Corner:
    """The outward normal of a piece, of unit length: radius, height. Outward is on its right."""
    size = math.dist(a, b)
    return (b[1] - a[1]) / size, (a[0] - b[0]) / size


def _mitred(corner: Corner, before: Corner | None, after: Corner | None, by_m: float) -> Corner:
    """Where two walls meet after each has moved by ``by_m`` along its normal; None is a piece on the axis."""
    one = before or after
    if one is None:
        return corner
    other = after or before
    assert other is not None, "one of the two is a wall"
    if corner[0] == 0 and (before is None or after is None):
        return 0.0, corner[1] + (by_m / one[1] if one[1] else 0.0)
    share = by_m / (1 + one[0] * other[0] + one[1] * other[1])
    return max(0.0, corner[0] + share * (one[0] + other[0])), corner[1] + share * (one[1] + other[1])


def _way_through(wall: tuple[Corner, Corner], outline: list[tuple[Corner, Corner]]) -> float:
    """From the middle of a wall straight inwards to the next piece of the whole cross-section."""
    (ar, ah), (br, bh) = wall
    out = _normal(*wall)
    middle, inward = np.array([(ar + br) / 2, (ah + bh) / 2]), np.array([-out[0], -out[1]])
    starts, ends = np.array([a for a, _ in outline]), np.array([b for _, b in outline])
    edges, away = ends - starts, starts - middle

    # Solve middle + t inward = start + s edge; what the way leaves is the wall itself, at t = 0.
    turn = inward[0] * edges[:, 1] - inward[1] * edges[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (away[:, 0] * edges[:, 1] - away[:, 1] * edges[:, 0]) / turn
        s = (away[:, 0] * inward[1] - away[:, 1] * inward[0]) / turn
    met = t[(turn != 0) & (s >= 0) & (s <= 1) & (t > 1e-9 * math.dist(*wall))]
    return float(met.min()) if len(met) else math.inf
