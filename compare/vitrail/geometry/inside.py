"""How deep points lie inside a shape: the exact sign for every analytic shape, the distance for most.

``depth_in(item, points)`` is positive inside, negative outside, zero on the surface, in metres; its size never exceeds
the distance to the surface. A plane counts as the half space below its normal. Flat shapes have no inside.
"""

from __future__ import annotations

from typing import assert_never

import numpy as np

from vitrail.base.vector import Vec
from vitrail.geometry.mesh_of import solid_of
from vitrail.geometry.placement import Frame, place
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Object, Plane, Prism, Rectangle, Sphere


def is_solid(item: Object) -> bool:
    """Whether the shape encloses something: all but rectangle and disc (a plane bounds the half space below it)."""
    return not isinstance(item.shape, Rectangle | Disc)


def contains(item: Object, point: Vec) -> bool:
    """Whether a point lies strictly inside. A mesh without a full path contains nothing."""
    return bool(is_inside(item, np.array([point], float))[0])


def is_inside(item: Object, points: np.ndarray) -> np.ndarray:
    """Which (n,) of world points (n, 3) lie strictly inside; cheaper than how deep for meshes."""
    placed = place(item)
    if isinstance(placed.shape, Mesh) and (solid := solid_of(placed)) is not None:
        return solid.winding(points) > 0
    return depth_in(item, points) > 0


def depth_in(item: Object, points: np.ndarray) -> np.ndarray:
    """Depth (n,) of world points (n, 3) in metres; -inf for shapes without an inside."""
    placed = place(item)
    shape, local = placed.shape, _to_local(placed.frame, points)
    match shape:
        case Sphere():
            return shape.radius - np.linalg.norm(local - shape.center, axis=1)
        case Plane():
            normal = np.asarray(shape.normal) / np.linalg.norm(shape.normal)
            return -(local - shape.point) @ normal
        case Box():
            return np.minimum(local - shape.min, np.subtract(shape.max, local)).min(axis=1)
        case Cylinder():
            return _frustum(local, shape.from_, shape.to, shape.radius, shape.radius)
        case Cone():
            return _frustum(local, shape.from_, shape.to, shape.radius_from, shape.radius_to)
        case Prism():
            return np.minimum(shape.height / 2 - np.abs(local[:, 2]), _polygon(local[:, :2], np.array(shape.corners)))
        case Lens():
            return _lens(local, shape)
        case Mesh():
            solid = solid_of(placed)
            return solid.depth(points) if solid is not None else np.full(len(points), -np.inf)
        case Rectangle() | Disc():
            return np.full(len(points), -np.inf)
        case _:
            assert_never(shape)


def _to_local(frame: Frame, points: np.ndarray) -> np.ndarray:
    if frame.is_identity:
        return np.asarray(points, float)
    return (np.asarray(points, float) - frame.origin) @ np.array(frame.rotation)


def _frustum(points: np.ndarray, start: Vec, end: Vec, radius_start: float, radius_end: float) -> np.ndarray:
    """Depth in a closed cone or cylinder: the nearest of its two discs and its mantle."""
    axis = np.subtract(end, start)
    length = np.linalg.norm(axis)
    axis = axis / length
    along = (points - start) @ axis
    aside = np.linalg.norm(points - start - np.outer(along, axis), axis=1)
    slope = (radius_end - radius_start) / length
    mantle = (radius_start + slope * along - aside) / np.hypot(1, slope)
    return np.minimum(np.minimum(along, length - along), mantle)


def _polygon(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Depth in a simple polygon, convex or not: distance to the nearest edge with the sign of the crossing count."""
    inside = np.zeros(len(points), bool)
    distance = np.full(len(points), np.inf)
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        # Count the edges that a ray towards +x crosses.
        straddles = (a[1] > points[:, 1]) != (b[1] > points[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            crossing = a[0] + (points[:, 1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
        inside ^= straddles & (points[:, 0] < crossing)
        # Keep the distance to the nearest point of any edge; a corner given twice has none.
        edge = b - a
        if not edge.any():
            continue
        along = np.clip((points - a) @ edge / (edge @ edge), 0, 1)
        distance = np.minimum(distance, np.linalg.norm(points - a - np.outer(along, edge), axis=1))
    return np.where(inside, distance, -distance)


def _lens(points: np.ndarray, lens: Lens) -> np.ndarray:
    """Depth between the two faces and inside the rim; the front face is the one at -z."""
    rim = lens.diameter / 2 - np.hypot(points[:, 0], points[:, 1])
    front = _face(points, lens.radius_front, -lens.thickness / 2, -1.0)
    back = _face(points, lens.radius_back, lens.thickness / 2, 1.0)
    return np.minimum(rim, np.minimum(front, back))


def _face(points: np.ndarray, radius: float, vertex: float, outward: float) -> np.ndarray:
    """Depth behind one face with its vertex on the axis; ``outward`` is the sign of z that points out of the glass."""
    if radius == 0:
        return outward * (vertex - points[:, 2])
    center = np.array([0.0, 0.0, vertex - outward * radius])
    distance = np.linalg.norm(points - center, axis=1)
    if radius > 0:
        return radius - distance
    # A concave face is taken from the glass as the near half of its ball; what lies beyond that is outside too.
    return np.minimum(distance + radius, outward * (center[2] - points[:, 2]))
