"""Simple polygons in a plane: whether a list of corners is one, and how deep points lie in it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from vitrail.base.fault import Fault

Corner = tuple[float, float]


def edges_of(corners: Sequence[Corner]) -> list[tuple[Corner, Corner]]:
    """From each corner to the next, the last one back to the first."""
    return list(zip(corners, [*corners[1:], *corners[:1]], strict=True))


def turns_left(corners: Sequence[Corner]) -> bool:
    """Whether all corners of a counter-clockwise polygon turn left: it is convex."""
    turns = []
    for a, b, c in zip(corners, [*corners[1:], *corners[:1]], [*corners[2:], *corners[:2]], strict=True):
        turns.append((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]))
    return min(turns) >= 0


def depth_in_polygon(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Depth in a simple polygon, convex or not: distance to the nearest edge with the sign of the crossing count."""
    inside = np.zeros(len(points), bool)
    distance = np.full(len(points), np.inf)
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        inside ^= is_crossed(points, a, b)
        distance = np.minimum(distance, distance_to_edge(points, a, b))
    return np.where(inside, distance, -distance)


def is_crossed(points: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Whether rays from points (n, 2) towards +x cross an edge, which counts its lower end and not its upper one."""
    straddles = (a[1] > points[:, 1]) != (b[1] > points[:, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        crossing = a[0] + (points[:, 1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
    return np.asarray(straddles & (points[:, 0] < crossing))


def distance_to_edge(points: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Distance (n,) of points to the nearest point of an edge; infinite for an edge without a length."""
    edge = b - a
    if not edge.any():
        return np.full(len(points), np.inf)
    along = np.clip((points - a) @ edge / (edge @ edge), 0, 1)
    return np.asarray(np.linalg.norm(points - a - np.outer(along, edge), axis=1))


def polygon_fault(corners: Sequence[Corner]) -> Fault | None:
    """Why corners are no simple polygon; None if they are one."""
    edges = edges_of(corners)
    if any(start == end for start, end in edges):
        return Fault("the profile repeats a corner", "give each corner once; the last edge closes by itself")
    for first in range(len(edges)):
        for second in range(first + 2, len(edges)):
            if (first, second) != (0, len(edges) - 1) and _cross_each_other(*edges[first], *edges[second]):
                what = f"the profile crosses itself: edges {first + 1} and {second + 1} meet"
                return Fault(what, "put the corners in order around the outline")
    if sum(a[0] * b[1] - b[0] * a[1] for a, b in edges) == 0:
        return Fault("the profile encloses no area", "move a corner off the line of the others")
    return None


def _cross_each_other(a: Corner, b: Corner, c: Corner, d: Corner) -> bool:
    """Whether the segments ab and cd share a point."""
    turns = (_turn(a, b, c), _turn(a, b, d), _turn(c, d, a), _turn(c, d, b))
    if turns[0] * turns[1] < 0 and turns[2] * turns[3] < 0:
        return True
    ends = ((a, b, c, turns[0]), (a, b, d, turns[1]), (c, d, a, turns[2]), (c, d, b, turns[3]))
    return any(turn == 0 and _between(p, q, r) for p, q, r, turn in ends)


def _turn(a: Corner, b: Corner, c: Corner) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _between(a: Corner, b: Corner, c: Corner) -> bool:
    """Whether c, known to be on the line ab, lies between a and b."""
    return all(min(p, q) <= r <= max(p, q) for p, q, r in zip(a, b, c, strict=True))
