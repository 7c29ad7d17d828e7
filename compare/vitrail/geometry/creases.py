"""Sharp edges of smooth meshes: where faces without normals turn by much, they stay apart.

A vertex on such an edge becomes one for each side, so that each side has normals of its own in every engine.
"""

from __future__ import annotations

import math

import numpy as np

CREASE_DEG = 40.0
"""Turn of two faces from which on their edge is sharp: that of a polygon of nine sides. A ball of twelve is smooth."""


def split_at_creases(vertices: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (n, 3) and triangles (m, 3), the same where no edge is sharp."""
    first, second, is_smooth = _edges(vertices, triangles)
    if is_smooth.all():
        return vertices, triangles
    count, flat = len(triangles), triangles.ravel()
    # Join the corners at either end of every smooth edge; the two triangles pass it in opposite directions or not.
    pairs = []
    for a in (first, _following(first)):
        for b in (second, _following(second)):
            pairs.append(np.stack([a, b])[:, is_smooth & (flat[a] == flat[b])])
    group = _joined(3 * count, np.concatenate(pairs, axis=1))
    _, where, new = np.unique(group, return_index=True, return_inverse=True)
    return vertices[flat[where]], new.reshape(count, 3)


def _edges(vertices: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Each edge with two triangles: the corner at which either begins it, and whether they turn by little there."""
    flat = triangles.ravel().astype(np.int64)
    begin, end = flat, flat[_following(np.arange(len(flat)))]
    key = np.minimum(begin, end) * (len(vertices) + 1) + np.maximum(begin, end)
    order = np.argsort(key, kind="stable")
    is_pair = key[order[:-1]] == key[order[1:]]
    first, second = order[:-1][is_pair], order[1:][is_pair]
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, size, out=np.zeros_like(normals), where=size > 0)
    cosine = np.einsum("ij,ij->i", normals[first // 3], normals[second // 3])
    return first, second, cosine >= math.cos(math.radians(CREASE_DEG))


def _following(corner: np.ndarray) -> np.ndarray:
    """The next corner of the same triangle."""
    return corner - corner % 3 + (corner + 1) % 3


def _joined(count: int, pairs: np.ndarray) -> np.ndarray:
    """The least member of the group of each of ``count``, where every one of ``pairs`` (2, k) is in one group."""
    group = np.arange(count)
    while True:
        a, b = group[pairs[0]], group[pairs[1]]
        if (a == b).all():
            return group
        # Hang the later group on the earlier one, then let all point to the first of theirs.
        np.minimum.at(group, np.maximum(a, b), np.minimum(a, b))
        while not np.array_equal(group, group[group]):
            group = group[group]
