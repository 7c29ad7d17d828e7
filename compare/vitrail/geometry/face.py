"""The surfaces around a solid, each as a whole: what two solids share where they are flush."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, assert_never

from vitrail.base.vector import Vec, dot, length, scale, subtract, unit
from vitrail.geometry.touch import TOUCH

ORIGIN: Vec = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Face:
    """A whole surface in the world.

    ``direction`` is of unit length: the outward normal of a plane, the axis of a cylinder or cone. ``point`` lies on
    the plane or the axis, or is the middle of a sphere or torus or the tip of a cone; ``size`` is a radius, that of the
    tube for a torus, or a cone's slope. ``ring`` is the radius of a torus to the middle of its tube, else 0.
    """

    kind: Literal["plane", "sphere", "cylinder", "cone", "torus"]
    direction: Vec
    point: Vec
    size: float
    ring: float = 0.0

    def is_same(self, other: Face) -> bool:
        """Whether two surfaces are the same one, seen from the same side."""
        slack = TOUCH * max(1.0, length(self.point), length(other.point), abs(self.size))
        if self.kind != other.kind or math.dist(self.direction, other.direction) > TOUCH:
            return False
        if abs(self.size - other.size) > slack or abs(self.ring - other.ring) > slack:
            return False
        between = subtract(other.point, self.point)
        match self.kind:
            case "plane":
                return abs(dot(self.direction, between)) <= slack
            case "cylinder":
                aside = subtract(between, scale(self.direction, dot(self.direction, between)))
                return length(aside) <= slack
            case "sphere" | "cone" | "torus":
                return length(between) <= slack
            case _:
                assert_never(self.kind)


def flat_face(normal: Vec, point: Vec) -> Face:
    """A plane through ``point``."""
    return Face("plane", unit(normal), point, 0.0)


def round_face(center: Vec, radius: float) -> Face:
    """A sphere; a radius below 0 is seen from its inside."""
    return Face("sphere", ORIGIN, center, radius)


def tube_face(axis: Vec, point: Vec, radius: float) -> Face:
    """A cylinder about an axis of unit length, which may point either way."""
    return Face("cylinder", _either_way(axis), point, radius)


def cone_face(direction: Vec, tip: Vec, slope: float) -> Face:
    """A cone that widens from its tip along a direction of unit length; a slope below 0 is seen from its inside."""
    return Face("cone", direction, tip, slope)


def torus_face(axis: Vec, center: Vec, ring: float, tube: float) -> Face:
    """A torus about an axis of unit length, which may point either way."""
    return Face("torus", _either_way(axis), center, tube, ring)


def _either_way(axis: Vec) -> Vec:
    return axis if axis > (-axis[0], -axis[1], -axis[2]) else scale(axis, -1)
