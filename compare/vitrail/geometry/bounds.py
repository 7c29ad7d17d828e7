"""How much room a thing takes: axis-aligned boxes in the world, possibly infinite.

Bounds answer only questions that are safe to answer with too large a box: *may* a light reach it, *may* the camera
see it. Nothing here is a hit test.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import product

from vitrail.base.vector import Vec, add, length, scale, subtract, unit


@dataclass(frozen=True)
class Bounds:
    """A closed box in world coordinates, metres; infinite where the thing is."""

    low: Vec
    high: Vec

    @property
    def is_finite(self) -> bool:
        return all(math.isfinite(value) for value in self.low + self.high)

    @property
    def centre(self) -> Vec:
        return scale(add(self.low, self.high), 0.5)

    @property
    def radius_m(self) -> float:
        """Radius of the sphere around the box; infinite for infinite bounds."""
        return 0.5 * length(subtract(self.high, self.low)) if self.is_finite else math.inf

    @property
    def corners(self) -> tuple[Vec, ...]:
        return tuple(product(*zip(self.low, self.high, strict=True)))  # type: ignore[arg-type]


EVERYWHERE = Bounds((-math.inf,) * 3, (math.inf,) * 3)


def around(points: Iterable[Vec]) -> Bounds:
    """The smallest box that holds all points; at least one is needed."""
    columns = list(zip(*points, strict=True))
    low, high = [min(column) for column in columns], [max(column) for column in columns]
    return Bounds((low[0], low[1], low[2]), (high[0], high[1], high[2]))


def together(boxes: Iterable[Bounds]) -> Bounds:
    """The smallest box that holds all boxes; at least one is needed."""
    return around(point for box in boxes for point in (box.low, box.high))


def about(center: Vec, half: Vec) -> Bounds:
    """The box that reaches ``half`` from its middle along each axis."""
    return Bounds(subtract(center, half), add(center, half))


def about_parallelogram(center: Vec, u: Vec, v: Vec) -> Bounds:
    """The box around ``center + a u + b v`` for a, b in [-1, 1]."""
    return about(center, (abs(u[0]) + abs(v[0]), abs(u[1]) + abs(v[1]), abs(u[2]) + abs(v[2])))


def about_disc(center: Vec, normal: Vec, radius: float) -> Bounds:
    """A disc reaches radius sqrt(1 - n_i^2) along axis i."""
    n = unit(normal)
    reach = [radius * math.sqrt(max(0.0, (1 - n[i]) * (1 + n[i]))) for i in range(3)]
    return about(center, (reach[0], reach[1], reach[2]))
