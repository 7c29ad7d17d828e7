"""How far a small turn of a ray at one object moves light on the screen, in pixels.

Light that an object turns by a radians lands d a away on a receiver at distance d; the camera at distance D sees that
as d a / D radians. A thing at distance b behind the object, seen through it from distance c, moves by a b / (b + c).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.vector import Vec, length, subtract, unit
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.camera import View
from vitrail.geometry.shapes.flat import PlacedPlane, plane_distance
from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.plan.in_picture import plane_hits
from vitrail.scene.model import Object


@dataclass(frozen=True)
class Lever:
    """Pixels on the screen per radian of turn: a typical number, and one that is never exceeded.

    Both hold for turns small against 1 radian, on a receiver that faces the light and the camera. ``where`` names the
    receiver, or says that it is what is seen ``through`` the object.
    """

    typical_px: float
    most_px: float
    where: str
    through: bool = False


def lever_on(world: World, source: Object, receiver: Object) -> Lever:
    """Light turned at ``source``, seen on ``receiver``."""
    view, origin, onto = world.view, world.bounds(source), world.solid(receiver)
    target = _near_point(origin.centre, onto) if origin.is_finite else view.position
    way = length(subtract(target, origin.centre)) if origin.is_finite else math.inf
    pixel = view.pixel_size_m(target)
    typical = way / pixel if pixel > 0 and math.isfinite(way) else 1 / view.pixel_angle
    return Lever(typical, _most_on(view, origin, onto), f"on `{receiver.name}`")


def lever_through(view: View) -> Lever:
    """What is seen in or through a thing: at worst everything behind it is far away, and turns as the ray does."""
    if view.perspective:
        return Lever(1 / view.pixel_angle, 1 / view.pixel_angle, "in what is seen in or through it", True)
    return Lever(math.inf, math.inf, "in what is seen in or through it", True)


def _most_on(view: View, origin: Bounds, receiver: Solid) -> float:
    """An upper bound of d / D over the seen part of a receiver, over the angle of a pixel.

    Perspective: d <= D + |source camera|, so d / D <= 1 + |source camera| / D with the nearest D. Orthographic: the
    farthest seen point over the size of a pixel.
    """
    if not origin.is_finite:
        return math.inf
    if view.perspective:
        apart = length(subtract(origin.centre, view.position)) + origin.radius_m
        nearest = _nearest_m(view.position, receiver)
        return (1 + apart / nearest) / view.pixel_angle if nearest > 0 else math.inf
    points = _seen_points(view, receiver)
    farthest = max((length(subtract(point, origin.centre)) for point in points), default=math.inf)
    return (farthest + origin.radius_m) / view.pixel_size_m(view.position)


def _nearest_m(point: Vec, solid: Solid) -> float:
    """A distance that no point of a solid falls below."""
    if isinstance(solid, PlacedPlane):
        return abs(plane_distance(solid.shape, point))
    bounds = solid.bounds
    if not bounds.is_finite:
        return 0.0
    outside = [max(low - p, p - high, 0.0) for low, p, high in zip(bounds.low, point, bounds.high, strict=True)]
    return math.hypot(*outside)


def _near_point(point: Vec, solid: Solid) -> Vec:
    """A typical point of a receiver: the foot on a plane, the middle of anything else."""
    if isinstance(solid, PlacedPlane):
        normal, height = unit(solid.shape.normal), plane_distance(solid.shape, point)
        return subtract(point, (normal[0] * height, normal[1] * height, normal[2] * height))
    bounds = solid.bounds
    return bounds.centre if bounds.is_finite else point


def _seen_points(view: View, solid: Solid) -> list[Vec]:
    """Corners of what an orthographic camera sees of a receiver."""
    if isinstance(solid, PlacedPlane):
        return plane_hits(view, solid.shape)
    bounds = solid.bounds
    return list(bounds.corners) if bounds.is_finite else []
