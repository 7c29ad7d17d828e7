"""Things that a straight ray leaves for good: flat pieces, and convex bodies seen from outside."""

from __future__ import annotations

import numpy as np

from vitrail.geometry.bounds import around
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.world import World
from vitrail.scene.model import Object

NEAR = 1e-9
"""A camera nearer to a face than this share of its distance from the origin may be on either side."""


def never_meets_itself(world: World, item: Object) -> bool:
    """Whether no light goes from a thing to itself where the camera could see it.

    Even a convex body lights and shadows itself inside; that shows through glass, or where the camera is inside too.
    """
    opaque = not world.scene.material_of(item).is_transmissive
    return opaque and world.solid(item).is_convex_or_flat and not camera_may_be_inside(world, item)


def camera_may_be_inside(world: World, item: Object) -> bool:
    """Whether rays of the camera may start inside a body; an opaque plane counts as a sheet without an inside."""
    solid, view = world.solid(item), world.view
    if solid.carrier is not None:
        return False
    if isinstance(solid, PlacedMesh):
        return True
    if view.perspective:
        slack = NEAR * (1 + float(np.linalg.norm(view.position)))
        return bool(solid.depth(np.array([view.position], float))[0] >= -slack)
    # The rays of an orthographic camera start all over its picture.
    starts, body = around(view.ray(sx, sy)[0] for sx in (-1.0, 1.0) for sy in (-1.0, 1.0)), solid.bounds
    return all(a <= d and c <= b for a, b, c, d in zip(starts.low, starts.high, body.low, body.high, strict=True))
