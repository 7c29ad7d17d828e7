"""Surface coordinates of flat shapes, in metres: where a checker lies. Both engines draw patterns by these."""

from __future__ import annotations

import math
from typing import assert_never

from vitrail.base.vector import Vec, cross, dot, scale, subtract, unit
from vitrail.scene.model import Disc, Plane, Rectangle

Flat = Plane | Rectangle | Disc


def frame_of(normal: Vec) -> tuple[Vec, Vec]:
    """Unit vectors (u, v) along a plane or disc with this normal; u, v, normal are right-handed.

    u is +x made perpendicular to the normal, or +z where the normal is nearly along x (|n.x| > 0.9); v = n x u.
    """
    n = unit(normal)
    axis = (1.0, 0.0, 0.0) if abs(n[0]) <= 0.9 else (0.0, 0.0, 1.0)
    u = unit(subtract(axis, scale(n, dot(axis, n))))
    return u, cross(n, u)


def surface_coordinates(shape: Flat, point: Vec) -> tuple[float, float]:
    """(s, t) in metres of a world point on a flat shape that stands in the world (see ``placement.place``).

    A plane's origin is its ``point``; a rectangle's and a disc's is the center. A rectangle uses its own u and v.
    """
    match shape:
        case Plane():
            origin, (u, v) = shape.point, frame_of(shape.normal)
        case Disc():
            origin, (u, v) = shape.center, frame_of(shape.normal)
        case Rectangle():
            origin, u, v = shape.center, unit(shape.u), unit(shape.v)
        case _:
            assert_never(shape)
    away = subtract(point, origin)
    return dot(away, u), dot(away, v)


def checker_index(s: float, t: float, size: float) -> int:
    """0 or 1: which of the two colours lies at the surface coordinates (s, t)."""
    return (math.floor(s / size) + math.floor(t / size)) & 1
