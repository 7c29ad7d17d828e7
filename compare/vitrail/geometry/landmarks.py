"""Points and directions that stand for a surface when it is asked whether another one touches it."""

from __future__ import annotations

import math

from vitrail.base.vector import Vec, add, scale
from vitrail.geometry.surface import tangents

STEPS = (-1.0, -0.5, 0.0, 0.5, 1.0)
"""Places along an edge, from end to end."""
RIM_POINTS = 16
AXES: tuple[Vec, ...] = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))


def rim(center: Vec, normal: Vec, radius: float) -> list[Vec]:
    """The middle of a disc and points on its edge."""
    u, v = tangents(normal)
    turns = [2 * math.pi * step / RIM_POINTS for step in range(RIM_POINTS)]
    edge = [add(center, add(scale(u, radius * math.cos(turn)), scale(v, radius * math.sin(turn)))) for turn in turns]
    return [center, *edge]


def both_ways(direction: Vec) -> list[Vec]:
    return [direction, scale(direction, -1)]
