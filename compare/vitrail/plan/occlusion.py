"""May an object stand between a light and a receiver: answered with no only where geometry proves it.

Finite things are taken as the spheres around them, planes as what they are. All that lies between a lamp and a receiver
is inside the capsule around the line from one sphere to the other.
"""

from __future__ import annotations

import math
from typing import assert_never

from vitrail.base.vector import Vec, add, dot, length, scale, subtract, unit
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.lamp import bounds_of_light
from vitrail.geometry.shapes.flat import plane_distance
from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.plan.convexity import never_meets_itself
from vitrail.scene.model import Area, Directional, Environment, Light, Object, Plane, Point, Spot

SLACK = 1e-9
"""Relative room given to every comparison, so that rounding never proves a shadow away."""


def may_shadow(world: World, light: Light, receiver: Object, occluder: Object) -> bool:
    """Whether ``occluder`` may take light of ``light`` from ``receiver``.

    An opaque convex or flat thing does not shadow itself: where it would, its surface faces away from the light. That
    is so for what is seen from outside.
    """
    target, obstacle = world.solid(receiver), world.solid(occluder)
    if lies_in_plane_of(target, obstacle):
        return False
    if occluder is receiver:
        return not never_meets_itself(world, occluder)
    emitter = light.emitter
    match emitter:
        case Environment():
            return True
        case Directional():
            return _shadows_parallel(emitter, target, obstacle)
        case Point() | Spot() | Area():
            return _shadows_from(bounds_of_light(light), target, obstacle)
        case _:
            assert_never(emitter)


def _shadows_from(lamp: Bounds, receiver: Solid, occluder: Solid) -> bool:
    """A lamp of finite size."""
    screen, wall = receiver.carrier, occluder.carrier
    target, obstacle = receiver.bounds, occluder.bounds
    if wall is not None and target.is_finite and _is_on_one_side(wall, [*lamp.corners, *target.corners]):
        return False
    if screen is not None and obstacle.is_finite and not _is_between(screen, lamp.corners, obstacle):
        return False
    if not (target.is_finite and obstacle.is_finite):
        return True
    reach = obstacle.radius_m + max(lamp.radius_m, target.radius_m)
    return _distance_to_segment(obstacle.centre, lamp.centre, target.centre) <= reach * (1 + SLACK)


def _shadows_parallel(sun: Directional, receiver: Solid, occluder: Solid) -> bool:
    """Light from infinity; with a size of its own it spreads the farther the obstacle is away."""
    back = scale(unit(sun.direction), -1.0)
    target, obstacle = receiver.bounds, occluder.bounds
    if sun.angular_diameter_deg == 0:
        screen, wall = receiver.carrier, occluder.carrier
        if wall is not None and target.is_finite and _is_toward(wall, back, target):
            return False
        if screen is not None and obstacle.is_finite and _is_behind(screen, back, obstacle):
            return False
    if not (target.is_finite and obstacle.is_finite):
        return True
    away = subtract(obstacle.centre, target.centre)
    ahead = dot(away, back)
    spread = math.tan(math.radians(sun.angular_diameter_deg) / 2) * length(away)
    reach = (obstacle.radius_m + target.radius_m + spread) * (1 + SLACK)
    aside = length(subtract(away, scale(back, ahead)))
    return ahead >= -reach and aside <= reach


def lies_in_plane_of(solid: Solid, flat: Solid) -> bool:
    """Whether all of a thing lies in the plane of another, flat one: no straight line leads from one to the other.

    A thing lies in its own plane too; to the bit, because what is out of it by a hair may be lit.
    """
    plane, bounds = flat.carrier, solid.bounds
    if plane is None or not bounds.is_finite or solid.carrier is None:
        return False
    return all(plane_distance(plane, corner) == 0 for corner in bounds.corners)


def _is_on_one_side(plane: Plane, points: list[Vec]) -> bool:
    """Whether no line between two of the points crosses the plane; touching it is not crossing."""
    heights = [plane_distance(plane, point) for point in points]
    return min(heights) >= 0 or max(heights) <= 0


def _is_toward(plane: Plane, back: Vec, target: Bounds) -> bool:
    """Whether a box lies on the side of a plane from which the light comes."""
    side = dot(unit(plane.normal), back)
    return side != 0 and all(plane_distance(plane, corner) * side >= 0 for corner in target.corners)


def _is_behind(screen: Plane, back: Vec, obstacle: Bounds) -> bool:
    """Whether a box lies on the far side of a screen, away from the light."""
    side = dot(unit(screen.normal), back)
    return all(plane_distance(screen, corner) * side <= 0 for corner in obstacle.corners)


def _is_between(screen: Plane, lamp: tuple[Vec, ...], obstacle: Bounds) -> bool:
    """Whether some of a box is above the screen, on the side of the lamp, and not wholly beyond the lamp."""
    sides = [plane_distance(screen, point) for point in lamp]
    if min(sides) < 0 < max(sides):
        return True
    sign, highest = (1.0 if max(sides) > 0 else -1.0), max(abs(side) for side in sides)
    heights = [sign * plane_distance(screen, corner) for corner in obstacle.corners]
    return max(heights) > 0 and min(heights) <= highest * (1 + SLACK)


def _distance_to_segment(point: Vec, start: Vec, end: Vec) -> float:
    along = subtract(end, start)
    square = dot(along, along)
    if square == 0:
        return length(subtract(point, start))
    share = min(1.0, max(0.0, dot(subtract(point, start), along) / square))
    return length(subtract(point, add(start, scale(along, share))))
