"""Things that a straight ray leaves for good: flat pieces, and convex bodies seen from outside."""

from __future__ import annotations

from typing import assert_never

import numpy as np

from vitrail.geometry.bounds import around, bounds_of
from vitrail.geometry.inside import depth_in
from vitrail.plan.view import view_of
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
    Scene,
    Sphere,
)

NEAR = 1e-9
"""A camera nearer to a face than this share of its distance from the origin may be on either side."""


def never_meets_itself(scene: Scene, item: Object) -> bool:
    """Whether no light goes from a thing to itself where the camera could see it.

    Even a convex body lights and shadows itself inside; that shows through glass, or where the camera is inside too.
    """
    opaque = not scene.material_of(item).is_transmissive
    return opaque and is_convex_or_flat(item) and not camera_may_be_inside(scene, item)


def camera_may_be_inside(scene: Scene, item: Object) -> bool:
    """Whether rays of the camera may start inside a body; an opaque plane counts as a sheet without an inside."""
    if isinstance(item.shape, (Plane, Rectangle, Disc)):
        return False
    if isinstance(item.shape, Mesh):
        return True
    camera = scene.camera
    if camera.kind == "perspective":
        slack = NEAR * (1 + float(np.linalg.norm(camera.position)))
        return bool(depth_in(item, np.array([camera.position], float))[0] >= -slack)
    # The rays of an orthographic camera start all over its picture.
    view, body = view_of(camera, scene.image), bounds_of(item)
    starts = around(view.corner_ray(sx, sy)[0] for sx in (-1.0, 1.0) for sy in (-1.0, 1.0))
    return all(a <= d and c <= b for a, b, c, d in zip(starts.low, starts.high, body.low, body.high, strict=True))


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
