"""How far a point is from the surface of a shape, inside or outside, in metres.

Exact where it is short to write; otherwise a lower bound, which is the safe side for everything that asks.
"""

from __future__ import annotations

import math
from typing import assert_never

import numpy as np

from vitrail.scene.inside import depth_in
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Object, Plane, Prism, Rectangle, Sphere
from vitrail.scene.placement import place
from vitrail.scene.vector import Vec, dot, length, scale, subtract, unit


def distance_to_surface(item: Object, point: Vec) -> float:
    """Distance in metres; infinite for a mesh, whose triangles are not read here."""
    placed = place(item)
    shape = placed.shape
    match shape:
        case Sphere():
            return abs(length(subtract(point, shape.center)) - shape.radius)
        case Plane():
            return abs(dot(unit(shape.normal), subtract(point, shape.point)))
        case Rectangle():
            return _rectangle(shape, point)
        case Disc():
            return _disc(shape.center, unit(shape.normal), shape.radius, point)
        case Box():
            return _box(shape, placed.frame.to_local(point))
        case Cylinder() | Cone() | Prism() | Lens():
            # The signed depth never exceeds the distance.
            return float(abs(depth_in(item, np.array([point], float))[0]))
        case Mesh():
            return math.inf
        case _:
            assert_never(shape)


def _rectangle(shape: Rectangle, point: Vec) -> float:
    away = subtract(point, shape.center)
    size_u, size_v = length(shape.u), length(shape.v)
    u, v = unit(shape.u), unit(shape.v)
    a, b = dot(away, u), dot(away, v)
    height = length(subtract(away, (u[0] * a + v[0] * b, u[1] * a + v[1] * b, u[2] * a + v[2] * b)))
    return math.hypot(max(abs(a) - size_u, 0.0), max(abs(b) - size_v, 0.0), height)


def _disc(center: Vec, normal: Vec, radius: float, point: Vec) -> float:
    away = subtract(point, center)
    height = dot(away, normal)
    aside = length(subtract(away, scale(normal, height)))
    return math.hypot(max(aside - radius, 0.0), height)


def _box(shape: Box, local: Vec) -> float:
    outside = [max(low - x, x - high, 0.0) for low, x, high in zip(shape.min, local, shape.max, strict=True)]
    if any(outside):
        return math.hypot(*outside)
    return min(min(x - low, high - x) for low, x, high in zip(shape.min, local, shape.max, strict=True))
