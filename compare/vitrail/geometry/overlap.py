"""How far two solids reach into each other.

Exact for sphere and sphere, sphere and box, box and box (turned or not), and for a half space with any of them. Every
other pair is searched for a point inside both: a point found proves the overlap, since the sign of ``depth_in`` is
exact; none found is no proof, although the search cannot miss much for convex shapes. A mesh is asked at points a
hair behind its faces, which finds what reaches into it or out of it over more than a few of them.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import lru_cache
from typing import assert_never

import numpy as np

from vitrail.geometry.inside import depth_in, is_inside
from vitrail.geometry.mesh_of import solid_of
from vitrail.geometry.mesh_solid import MeshSolid
from vitrail.geometry.placement import Placed, place
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Object, Plane, Prism, Rectangle, Sphere

TOUCH = 1e-9
"""Solids that reach into each other by less than this share of their size and distance from the origin only touch."""

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


def overlap(a: Object, b: Object) -> Overlap:
    """The depth of the volume that two solids share, less the tolerance for touching; symmetric in its arguments."""
    first, second = place(a), place(b)
    exact = _exact_depth(first, second)
    if exact is None:
        exact = _exact_depth(second, first)
    slack = TOUCH * max(_size(first), _size(second))
    if exact is not None:
        return Overlap(exact - slack, exact=True)
    return Overlap(_searched_depth(a, b, first, second) - slack, exact=False)


# --- exact pairs ----------------------------------------------------------------------------------------------------


def _exact_depth(a: Placed, b: Placed) -> float | None:
    """Penetration depth of the pairs that have a closed form, None for the others."""
    match a.shape, b.shape:
        case Sphere() as one, Sphere() as two:
            return one.radius + two.radius - float(np.linalg.norm(np.subtract(one.center, two.center)))
        case Sphere() as ball, Box() as box:
            return _sphere_in_box(ball, box, b)
        case Box(), Box():
            return _separating_axes(_corners(a), _axes(a), _corners(b), _axes(b))
        case Plane() as plane, Sphere() as ball:
            return ball.radius - _heights(plane, np.array([ball.center]))[0]
        case Plane() as plane, Box():
            return -float(_heights(plane, _corners(b)).min())
        case Plane() as one, Plane() as two:
            return _half_spaces(one, two)
        case _:
            return None


def _sphere_in_box(ball: Sphere, box: Box, placed: Placed) -> float:
    center = np.array(placed.frame.to_local(ball.center))
    nearest = np.clip(center, box.min, box.max)
    distance = float(np.linalg.norm(center - nearest))
    if distance > 0:
        return ball.radius - distance
    return ball.radius + float(np.minimum(center - box.min, np.subtract(box.max, center)).min())


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


def _half_spaces(one: Plane, two: Plane) -> float:
    """Two half spaces are apart only when their normals are opposite and the gap lies between them."""
    first, second = _unit(one.normal), _unit(two.normal)
    if np.linalg.norm(first + second) > 1e-12:
        return np.inf
    return float((np.subtract(one.point, two.point)) @ first)


def _heights(plane: Plane, points: np.ndarray) -> np.ndarray:
    """Signed distances above a plane."""
    return (points - plane.point) @ _unit(plane.normal)


def _unit(vector: tuple[float, float, float]) -> np.ndarray:
    return np.asarray(vector) / np.linalg.norm(vector)


def _axes(placed: Placed) -> np.ndarray:
    return np.array(placed.frame.rotation).T


def _corners(placed: Placed) -> np.ndarray:
    box = placed.shape
    assert isinstance(box, Box)
    (x0, y0, z0), (x1, y1, z1) = box.min, box.max
    return np.array([placed.frame.point(corner) for corner in itertools.product((x0, x1), (y0, y1), (z0, z1))])


# --- every other pair -----------------------------------------------------------------------------------------------


def _searched_depth(a: Object, b: Object, first: Placed, second: Placed) -> float:
    """The largest depth inside both that a search finds: random points, then ever smaller steps from the best."""
    rough = _ball_around(first), _ball_around(second)
    finite = [ball for ball in rough if ball is not None]
    if any(isinstance(each.shape, Mesh) for each in (first, second)):
        return _depth_with_mesh(a, b, _mesh(first), _mesh(second))
    if not finite:
        return -np.inf
    if len(finite) == 2 and np.linalg.norm(finite[0][0] - finite[1][0]) > finite[0][1] + finite[1][1]:
        return -np.inf
    center, radius = min(finite, key=lambda ball: ball[1])
    random = np.random.default_rng(0)
    points = center + radius * random.uniform(-1, 1, (_STARTS, 3))

    def common(candidates: np.ndarray) -> np.ndarray:
        return np.minimum(depth_in(a, candidates), depth_in(b, candidates))

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


def _mesh(placed: Placed) -> MeshSolid | None:
    return solid_of(placed) if isinstance(placed.shape, Mesh) else None


@lru_cache(maxsize=1024)
def _depth_with_mesh(a: Object, b: Object, mesh_a: MeshSolid | None, mesh_b: MeshSolid | None) -> float:
    """A depth that both solids have in common, one of which is a mesh; the largest of those at a few points."""
    random = np.random.default_rng(0)
    balls = [ball for ball in (_ball_around(place(a)), _ball_around(place(b))) if ball is not None]
    points = [center + radius * random.uniform(-1, 1, (_IN_BALL, 3)) for center, radius in balls]
    inwards = [np.zeros((_IN_BALL, 3)) for _ in balls]
    for solid in (mesh_a, mesh_b):
        if solid is not None:
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
    deep = np.maximum(depth_in(a, found[best]), depth_in(b, found[best]))
    further = _common_depth(a, b, found[best] + 0.5 * deep[:, None] * way[best])
    return float(max(depths[best].max(), further.max()))


def _common_depth(a: Object, b: Object, points: np.ndarray) -> np.ndarray:
    """The lesser depth (n,) in two solids, -inf outside either."""
    depths = np.full(len(points), -np.inf)
    inside = is_inside(a, points)
    inside[inside] = is_inside(b, points[inside])
    depths[inside] = np.minimum(depth_in(a, points[inside]), depth_in(b, points[inside]))
    return depths


def _ball_around(placed: Placed) -> tuple[np.ndarray, float] | None:
    """Center and radius of a sphere around a solid; None for half spaces, flat shapes and meshes."""
    shape, frame = placed.shape, placed.frame
    match shape:
        case Sphere():
            return np.array(shape.center), shape.radius
        case Box():
            return _centered(_corners(placed))
        case Cylinder() | Cone():
            radii = (
                (shape.radius, shape.radius) if isinstance(shape, Cylinder) else (shape.radius_from, shape.radius_to)
            )
            half = np.linalg.norm(np.subtract(shape.to, shape.from_)) / 2
            return np.add(shape.from_, shape.to) / 2, float(np.hypot(half, max(radii)))
        case Prism():
            outer = [frame.point((x, y, z)) for x, y in shape.corners for z in (-shape.height / 2, shape.height / 2)]
            return _centered(np.array(outer))
        case Lens():
            depth = shape.thickness / 2 + (shape.diameter / 2 if min(shape.radius_front, shape.radius_back) < 0 else 0)
            return np.array(frame.origin), float(np.hypot(shape.diameter / 2, depth))
        case Plane() | Rectangle() | Disc() | Mesh():
            return None
        case _:
            assert_never(shape)


def _centered(points: np.ndarray) -> tuple[np.ndarray, float]:
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    return center, float(np.linalg.norm(points - center, axis=1).max())


def _size(placed: Placed) -> float:
    """The size of the numbers that describe a solid, for tolerances, metres."""
    if isinstance(placed.shape, Mesh) and (solid := solid_of(placed)) is not None:
        return float(np.abs(solid.triangles.vertices).max()) + solid.size
    ball = _ball_around(placed)
    if ball is None:
        return float(np.linalg.norm(placed.shape.point)) if isinstance(placed.shape, Plane) else 0.0
    return float(np.linalg.norm(ball[0])) + ball[1]
