"""Polygons of a mesh cut into triangles: fans where a polygon is convex, ears where it is not."""

from __future__ import annotations

import numpy as np


class NotCuttable(ValueError):
    """A polygon that is no simple outline: its edges cross, or all its corners are on one line."""


def triangles_of(polygon: list[int], vertices: np.ndarray) -> list[tuple[int, int, int]]:
    """The triangles (indices into ``vertices`` (n, 3)) of one flat polygon, with its sense of turning.

    Raises NotCuttable for an outline that crosses itself, as far as its area or a missing ear tells.
    """
    first, *rest = polygon
    fan = [(first, b, c) for b, c in zip(rest, rest[1:], strict=False)]
    if len(fan) < 2:
        return fan
    corners = vertices[polygon]
    normal, areas = _normal(corners), np.cross(corners[1:-1] - corners[0], corners[2:] - corners[0])
    if areas.any() and not normal.any():
        raise NotCuttable("a polygon crosses itself")
    # A fan is right where none of its triangles turns back.
    return fan if (areas @ normal >= 0).all() else _ears(polygon, corners, normal)


def _normal(corners: np.ndarray) -> np.ndarray:
    """Twice the vector area of a closed outline (Newell's sum)."""
    return np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)


def _ears(polygon: list[int], corners: np.ndarray, normal: np.ndarray) -> list[tuple[int, int, int]]:
    """Cut off one ear after the other: a convex corner whose triangle holds no other corner."""
    left, found = list(range(len(polygon))), []
    while len(left) > 3:
        for k in range(len(left)):
            a, b, c = left[k - 1], left[k], left[(k + 1) % len(left)]
            others = corners[[each for each in left if each not in (a, b, c)]]
            if _turn(corners[a], corners[b], corners[c], normal) > 0 and not _holds(corners[[a, b, c]], others, normal):
                found.append((polygon[a], polygon[b], polygon[c]))
                del left[k]
                break
        else:
            raise NotCuttable("a polygon crosses itself")
    a, b, c = left
    return [*found, (polygon[a], polygon[b], polygon[c])]


def _turn(a: np.ndarray, b: np.ndarray, c: np.ndarray, normal: np.ndarray) -> float:
    return float(np.cross(b - a, c - b) @ normal)


def _holds(triangle: np.ndarray, points: np.ndarray, normal: np.ndarray) -> bool:
    """Whether any point lies in a triangle or on its edges."""
    inside = np.ones(len(points), bool)
    for k in range(3):
        edge = triangle[(k + 1) % 3] - triangle[k]
        inside &= np.cross(edge, points - triangle[k]) @ normal >= 0
    return bool(inside.any())
