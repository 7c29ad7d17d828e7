"""Surface coordinates of flat shapes, in metres: where a checker lies. Both engines draw patterns by these."""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.vector import Vec, cross, dot, scale, subtract, unit


@dataclass(frozen=True)
class SurfaceFrame:
    """Where surface coordinates are 0, the unit vectors along which they grow, and the unit normal.

    A plane's origin is its ``point``; a rectangle's and a disc's is the center. A rectangle uses its own u and v.
    """

    origin: Vec
    u: Vec
    v: Vec
    normal: Vec

    def coordinates(self, point: Vec) -> tuple[float, float]:
        """(s, t) in metres of a world point on the surface."""
        away = subtract(point, self.origin)
        return dot(away, self.u), dot(away, self.v)


def tangents(normal: Vec) -> tuple[Vec, Vec]:
    """Unit vectors (u, v) along a plane or disc with this normal; u, v, normal are right-handed.

    u is +x made perpendicular to the normal, or +z where the normal is nearly along x (|n.x| > 0.9); v = n x u.
    """
    n = unit(normal)
    axis = (1.0, 0.0, 0.0) if abs(n[0]) <= 0.9 else (0.0, 0.0, 1.0)
    u = unit(subtract(axis, scale(n, dot(axis, n))))
    return u, cross(n, u)


def checker_index(s: float, t: float, size: float) -> int:
    """0 or 1: which of the two colours lies at the surface coordinates (s, t)."""
    return (math.floor(s / size) + math.floor(t / size)) & 1
