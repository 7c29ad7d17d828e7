"""Polygons of a mesh cut into triangles: fans where a polygon is convex, ears where it is not."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

MOST_LOOKS = 1 << 25
"""Corners that are looked at for the concave polygons of one file, some 5 s; a comb of 300 teeth needs a tenth."""

LOOKS_PER_TRIAL = 300
"""What it costs to try one ear, however few corners are left."""


class NotCuttable(ValueError):
    """A polygon that is no simple outline: its edges cross, or all its corners are on one line."""


@dataclass
class Effort:
    """What may still be spent on one file."""

    looks: int = MOST_LOOKS

    def spend(self, looks: int) -> None:
        self.looks -= looks
        if self.looks < 0:
            raise NotCuttable("its concave polygons have too many corners; cut them into triangles")


def triangles_of(corners: np.ndarray, counts: np.ndarray, vertices: np.ndarray) -> np.ndarray:
    """The triangles (m, 3), indices into ``vertices`` (n, 3), of flat polygons, with their sense of turning.

    ``corners`` are those of all polygons, ``counts`` how many each has; fewer than three enclose nothing. Raises
    NotCuttable for an outline that crosses itself, as far as its area or a missing ear tells.
    """
    corners, counts = np.asarray(corners, int), np.asarray(counts, int)
    made = np.maximum(counts - 2, 0)
    start, first = np.cumsum(counts) - counts, np.cumsum(made) - made
    found = np.empty((int(made.sum()), 3), int)
    effort = Effort()
    for size in np.unique(counts[counts > 2]):
        rows = np.flatnonzero(counts == size)
        polygons = corners[start[rows][:, None] + np.arange(size)]
        found[first[rows][:, None] + np.arange(size - 2)] = _cut(polygons, vertices, effort)
    return found


def _cut(polygons: np.ndarray, vertices: np.ndarray, effort: Effort) -> np.ndarray:
    """The triangles (r, k - 2, 3) of polygons (r, k)."""
    rest = polygons[:, 1:]
    fans = np.stack([np.broadcast_to(polygons[:, :1], rest[:, :-1].shape), rest[:, :-1], rest[:, 1:]], axis=2)
    if polygons.shape[1] == 3:
        return fans
    corners = vertices[polygons]
    normal = np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1)
    areas = np.cross(corners[:, 1:-1] - corners[:, :1], corners[:, 2:] - corners[:, :1])
    if (areas.any(axis=(1, 2)) & ~normal.any(axis=1)).any():
        raise NotCuttable("a polygon crosses itself")
    # A fan is right where none of its triangles turns back.
    turns_back = (np.einsum("rki,ri->rk", areas, normal) < 0).any(axis=1)
    for row in np.flatnonzero(turns_back):
        fans[row] = polygons[row][_ears(corners[row], normal[row], effort)]
    return fans


def _ears(corners: np.ndarray, normal: np.ndarray, effort: Effort) -> list[tuple[int, int, int]]:
    """Cut off one ear after the other: a convex corner whose triangle holds no other corner."""
    left, found = list(range(len(corners))), []
    while len(left) > 3:
        for k in range(len(left)):
            effort.spend(LOOKS_PER_TRIAL + len(left))
            a, b, c = left[k - 1], left[k], left[(k + 1) % len(left)]
            others = corners[[each for each in left if each not in (a, b, c)]]
            if _turn(corners[a], corners[b], corners[c], normal) > 0 and not _holds(corners[[a, b, c]], others, normal):
                found.append((a, b, c))
                del left[k]
                break
        else:
            raise NotCuttable("a polygon crosses itself")
    return [*found, (left[0], left[1], left[2])]


def _turn(a: np.ndarray, b: np.ndarray, c: np.ndarray, normal: np.ndarray) -> float:
    return float(np.cross(b - a, c - b) @ normal)


def _holds(triangle: np.ndarray, points: np.ndarray, normal: np.ndarray) -> bool:
    """Whether any point lies in a triangle or on its edges."""
    inside = np.ones(len(points), bool)
    for k in range(3):
        edge = triangle[(k + 1) % 3] - triangle[k]
        inside &= np.cross(edge, points - triangle[k]) @ normal >= 0
    return bool(inside.any())
