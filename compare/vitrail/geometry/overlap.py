"""How far two solids reach into each other.

Exact for sphere and sphere, sphere and box, box and box (turned or not), and for a half space with any of them. Every
other pair is searched for a point inside both: a point found proves the overlap, since the sign of ``Solid.depth`` is
exact; none found is no proof, although the search cannot miss much for convex shapes. A mesh is asked at points a
hair behind its faces, which finds what reaches into it or out of it over more than a few of them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vitrail.base.vector import Vec
from vitrail.geometry.shapes.box import PlacedBox
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.shapes.sphere import PlacedSphere
from vitrail.geometry.solid import Solid
from vitrail.geometry.touch import TOUCH

_STARTS = 4096
_ROUNDS = 40
_IN_BALL = 64
_DEEPEST = 16


@dataclass(frozen=True)
class Overlap:
    """``depth_m`` > 0 where the solids share volume; ``exact`` tells whether 0 or less is a proof that they do not."""

    depth_m: float
    exact: bool

    def __bool__(self) -> bool:
        return bool(self.depth_m > 0)


def overlap(a: Solid, b: Solid) -> Overlap:
    """The depth of the volume that two solids share, less the tolerance for touching; symmetric in its arguments."""
    exact = _exact_depth(a, b)
    if exact is None:
        exact = _exact_depth(b, a)
    slack = TOUCH * max(a.number_size_m, b.number_size_m)
    if exact is not None:
        return Overlap(exact - slack, exact=True)
    if isinstance(a, PlacedMesh) or isinstance(b, PlacedMesh):
        return Overlap(_depth_with_mesh(a, b) - slack, exact=False)
    return Overlap(_searched_depth(a, b) - slack, exact=False)


# --- exact pairs ----------------------------------------------------------------------------------------------------


def _exact_depth(a: Solid, b: Solid) -> float | None:
    """Penetration depth of the pairs that have a closed form; None for the others, which are searched."""
    match a, b:
        case PlacedSphere(), PlacedSphere():
            apart = float(np.linalg.norm(np.subtract(a.shape.center, b.shape.center)))
            return a.shape.radius + b.shape.radius - apart
        case PlacedSphere(), PlacedBox():
            return _sphere_in_box(a, b)
        case PlacedBox(), PlacedBox():
            return _separating_axes(a.corners, _axes(a), b.corners, _axes(b))
        case PlacedPlane(), PlacedSphere():
            return b.shape.radius - float(_heights(a, np.array([b.shape.center]))[0])
        case PlacedPlane(), PlacedBox():
            return -float(_heights(a, b.corners).min())
        case PlacedPlane(), PlacedPlane():
            return _half_spaces(a, b)
    return None


def _sphere_in_box(ball: PlacedSphere, box: PlacedBox) -> float:
    low, high = box.shape.min, box.shape.max
    center = np.array(box.frame.to_local(ball.shape.center))
    distance = float(np.linalg.norm(center - np.clip(center, low, high)))
    if distance > 0:
        return ball.shape.radius - distance
    return ball.shape.radius + float(np.minimum(center - low, np.subtract(high, center)).min())


def _separating_axes(corners_a: np.ndarray, axes_a: np.ndarray, corners_b: np.ndarray, axes_b: np.ndarray) -> float:
    """The smallest overlap of the projections on the 15 axes that can separate two boxes; negative when one does."""
    candidates = [*axes_a, *axes_b, *(np.cross(p, q) for p in axes_a for q in axes_b)]
    depth = np.inf
    for axis in candidates:
        size = np.linalg.norm(axis)
        if size < 1e-9:  # Parallel edges add no axis of their own.
            continue
        along_a, along_b = corners_a @ (axis / size), corners_b @ (axis / size)
        depth = min(depth, along_a.max() - along_b.min(), along_b.max() - along_a.min())
    return float(depth)


def _half_spaces(one: PlacedPlane, two: PlacedPlane) -> float:
    """Two half spaces are apart only when their normals are opposite and the gap lies between them."""
    first, second = _unit(one.shape.normal), _unit(two.shape.normal)
    if np.linalg.norm(first + second) > 1e-12:
        return np.inf
    return float((np.subtract(one.shape.point, two.shape.point)) @ first)


def _heights(plane: PlacedPlane, points: np.ndarray) -> np.ndarray:
    """Signed distances above a plane."""
    return (points - plane.shape.point) @ _unit(plane.shape.normal)


def _unit(vector: Vec) -> np.ndarray:
    return np.asarray(vector) / np.linalg.norm(vector)


def _axes(box: PlacedBox) -> np.ndarray:
    return np.array(box.frame.rotation).T


# --- every other pair -----------------------------------------------------------------------------------------------


def _searched_depth(a: Solid, b: Solid) -> float:
    """The largest depth inside both that a search finds: random points, then ever smaller steps from the best."""
    finite = [ball for ball in (a.ball, b.ball) if ball is not None]
    if not finite:
        return -np.inf
    if len(finite) == 2 and np.linalg.norm(finite[0][0] - finite[1][0]) > finite[0][1] + finite[1][1]:
        return -np.inf
    center, radius = min(finite, key=lambda ball: ball[1])
    random = np.random.default_rng(0)
    points = center + radius * random.uniform(-1, 1, (_STARTS, 3))

    def common(candidates: np.ndarray) -> np.ndarray:
        return np.minimum(a.depth(candidates), b.depth(candidates))

    depths = common(points)
    best, depth = points[depths.argmax()], float(depths.max())
    step = radius
    for _ in range(_ROUNDS):
        candidates = best + step * random.uniform(-1, 1, (256, 3))
        depths = common(candidates)
        if depths.max() > depth:
            best, depth = candidates[depths.argmax()], float(depths.max())
        else:
            step *= 0.5
    return depth


def _depth_with_mesh(a: Solid, b: Solid) -> float:
    """A depth that both solids have in common, one of which is a mesh; the largest of those at a few points."""
    random = np.random.default_rng(0)
    balls = [ball for ball in (a.ball, b.ball) if ball is not None]
    points = [center + radius * random.uniform(-1, 1, (_IN_BALL, 3)) for center, radius in balls]
    inwards = [np.zeros((_IN_BALL, 3)) for _ in balls]
    for each in (a, b):
        if isinstance(each, PlacedMesh) and (solid := each.solid) is not None:
            points.append(solid.inner_points())
            inwards.append(-solid.normals[solid.sample])
    if not points:
        return -np.inf
    found, way = np.concatenate(points), np.concatenate(inwards)
    depths = _common_depth(a, b, found)
    best = np.argsort(depths)[-_DEEPEST:]
    best = best[depths[best] > 0]
    if len(best) == 0:
        return float(depths.max())
    # Go from the face of one half as far in as the other is deep there.
    deep = np.maximum(a.depth(found[best]), b.depth(found[best]))
    further = _common_depth(a, b, found[best] + 0.5 * deep[:, None] * way[best])
    return float(max(depths[best].max(), further.max()))


def _common_depth(a: Solid, b: Solid, points: np.ndarray) -> np.ndarray:
    """The lesser depth (n,) in two solids, -inf outside either."""
    depths = np.full(len(points), -np.inf)
    inside = a.is_inside(points)
    inside[inside] = b.is_inside(points[inside])
    depths[inside] = np.minimum(a.depth(points[inside]), b.depth(points[inside]))
    return depths
