"""Infinite planes that stand between a light and an object: all straight ways cross them, so no light arrives directly.

A plane blocks as everything does, whether it is glass or not; what a glass or mirror plane sends on is the plane's own
light, found by way of the plane.
"""

from __future__ import annotations

import math
from typing import assert_never

from vitrail.base.vector import Vec, dot, length, subtract, unit
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.world import World
from vitrail.scene.model import Area, Directional, Environment, Light, Object, Plane, Point, Spot

SLACK = 1e-9
"""Share of its size by which an object that touches a plane may reach through it."""


def is_shut_off(world: World, light: Light, item: Object) -> bool:
    """Whether some other infinite plane has the light on one side and all of an object on the other."""
    own = world.solid(item)
    planes = (solid.shape for solid in world.solids if solid is not own and isinstance(solid, PlacedPlane))
    return own.bounds.is_finite and any(_parts(plane, light, own.bounds) for plane in planes)


def _parts(plane: Plane, light: Light, bounds: Bounds) -> bool:
    normal = unit(plane.normal)
    lit = _lit_side(plane, normal, light)
    size = bounds.radius_m + length(subtract(bounds.centre, plane.point))
    heights = [dot(normal, subtract(corner, plane.point)) for corner in bounds.corners]
    return lit != 0 and all(lit * height <= SLACK * size for height in heights)


def _lit_side(plane: Plane, normal: Vec, light: Light) -> int:
    """The side that all of the light comes from: 1 where the normal points, -1 behind, 0 where there is none."""
    emitter = light.emitter
    match emitter:
        case Directional():
            toward = -dot(unit(emitter.direction), normal)
            reach = math.sin(math.radians(emitter.angular_diameter_deg) / 2) + SLACK
            return 0 if abs(toward) <= reach else int(math.copysign(1, toward))
        case Point() | Spot():
            height = dot(normal, subtract(emitter.position, plane.point))
            return 0 if height == 0 else int(math.copysign(1, height))
        case Area() | Environment():
            return 0
        case _:
            assert_never(emitter)
