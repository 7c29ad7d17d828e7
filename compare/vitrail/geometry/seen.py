"""What object the camera sees in a pixel: a ray that goes as far as no surface can be nearer, until one is there."""

from __future__ import annotations

import math

from vitrail.base.vector import add, scale, unit
from vitrail.geometry.camera import View
from vitrail.geometry.world import World

MOST_STEPS = 256
"""A ray along a plane comes nearer by a share of its distance each step; most need twenty."""

NEAR_PX = 0.25
"""A surface is met where the ray is within this share of a pixel of it."""

NEAREST = 1e-9
"""Share of the extent of the scene that counts as met where pixels have no size: on the camera itself."""


def seen_object(world: World, view: View, x_px: float, y_px: float) -> str:
    """The name of the object that a picture shows first at (x to the right, y down); "" where there is none.

    ``view`` is the world's camera with the size of the picture.
    """
    origin, direction = view.ray(2 * x_px / view.width - 1, 1 - 2 * y_px / view.height)
    forward, gone = unit(direction), 0.0
    end = 4 * world.extent.radius_m + math.dist(world.extent.centre, origin)
    for _ in range(MOST_STEPS):
        point = add(origin, scale(forward, gone))
        distances = [solid.distance(point) for solid in world.solids]
        # What is not known at a point, as the distance of a mesh without its file, stops no ray.
        index = min(range(len(distances)), key=distances.__getitem__, default=None)
        if index is None or not math.isfinite(distances[index]):
            return ""
        if distances[index] <= max(NEAR_PX * view.pixel_size_m(point), NEAREST * world.extent.radius_m):
            return world.scene.objects[index].name
        gone += distances[index]
        if gone > end:
            # Beyond all that is finite only a half space can be met.
            return _beyond(world, point, forward)
    return ""


def _beyond(world: World, point: tuple[float, float, float], forward: tuple[float, float, float]) -> str:
    """The half space that a ray will meet far away, if any."""
    for item, solid in zip(world.scene.objects, world.solids, strict=True):
        ahead = add(point, forward)
        if not solid.bounds.is_finite and solid.distance(ahead) < solid.distance(point):
            return item.name
    return ""
