"""Shapes that a straight ray leaves for good: convex bodies and flat pieces."""

from __future__ import annotations

from typing import assert_never

from vitrail.scene.model import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Lens,
    Mesh,
    Object,
    Plane,
    Prism,
    Rectangle,
    Sphere,
)


def is_convex_or_flat(item: Object) -> bool:
    """Whether no straight line leaves a thing and meets it again; a mesh, not read here, counts as hollow."""
    shape = item.shape
    match shape:
        case Sphere() | Plane() | Rectangle() | Disc() | Box() | Cylinder() | Cone():
            return True
        case Prism():
            return _turns_one_way(shape.corners)
        case Lens():
            return shape.radius_front >= 0 and shape.radius_back >= 0
        case Mesh():
            return False
        case _:
            assert_never(shape)


def _turns_one_way(corners: tuple[tuple[float, float], ...]) -> bool:
    """All corners of a counter-clockwise polygon turn left."""
    turns = []
    for a, b, c in zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2], strict=True):
        turns.append((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]))
    return min(turns) >= 0
