"""The axes in which an object is described, and where its rotation and translation put them.

``rotate_deg`` turns about the world axes through the origin, by x first, then y, then z; ``translate`` moves
afterwards: world = R local + origin with R = Rz Ry Rx.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from vitrail.base.vector import Vec, add, dot
from vitrail.scene.model import Object

if TYPE_CHECKING:
    import numpy as np

Rows = tuple[Vec, Vec, Vec]
IDENTITY: Rows = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True)
class Frame:
    """world = rotation local + origin; ``rotation`` holds the rows."""

    origin: Vec = (0.0, 0.0, 0.0)
    rotation: Rows = IDENTITY

    @property
    def is_identity(self) -> bool:
        return self.rotation == IDENTITY and self.origin == (0.0, 0.0, 0.0)

    def point(self, local: Vec) -> Vec:
        return add(self.direction(local), self.origin)

    def direction(self, local: Vec) -> Vec:
        """Turn without moving; an unturned frame returns the same bits."""
        if self.rotation == IDENTITY:
            return local
        return (dot(self.rotation[0], local), dot(self.rotation[1], local), dot(self.rotation[2], local))

    def local_points(self, points: np.ndarray) -> np.ndarray:
        """World points (n, 3) in the frame's own axes."""
        import numpy as np

        if self.is_identity:
            return np.asarray(points, float)
        return (np.asarray(points, float) - self.origin) @ np.array(self.rotation)

    def to_local(self, world: Vec) -> Vec:
        moved = (world[0] - self.origin[0], world[1] - self.origin[1], world[2] - self.origin[2])
        columns = tuple(zip(*self.rotation, strict=True))
        return (dot(columns[0], moved), dot(columns[1], moved), dot(columns[2], moved))


def frame_of(item: Object) -> Frame:
    """The frame that ``rotate_deg`` and ``translate`` describe."""
    return Frame(_vec(item.translate), _rotation(item.rotate_deg))


def _rotation(rotate_deg: Vec) -> Rows:
    """Rz Ry Rx with quarter turns exact, so that a scene turned by 90 degrees is turned to the last bit."""
    rotation = IDENTITY
    for axis in range(3):
        if rotate_deg[axis] != 0:
            rotation = _product(_turn(axis, rotate_deg[axis]), rotation)
    return rotation


def _turn(axis: int, angle_deg: float) -> Rows:
    c, s = _cosine_and_sine(angle_deg)
    match axis:
        case 0:
            return ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c))
        case 1:
            return ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c))
        case _:
            return ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0))


def _cosine_and_sine(angle_deg: float) -> tuple[float, float]:
    """Cosine and sine, exact at multiples of 90 degrees."""
    quarter, rest = divmod(angle_deg, 90.0)
    if rest == 0:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter) % 4]
    return math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))


def _product(a: Rows, b: Rows) -> Rows:
    columns = tuple(zip(*b, strict=True))
    rows = tuple((dot(row, columns[0]), dot(row, columns[1]), dot(row, columns[2])) for row in a)
    return (rows[0], rows[1], rows[2])


def _vec(value: Vec) -> Vec:
    return (float(value[0]), float(value[1]), float(value[2]))
