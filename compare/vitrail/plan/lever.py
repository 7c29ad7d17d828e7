"""How far a small turn of a ray at one object moves light on the screen, in pixels.

Light that an object turns by a radians lands d a away on a receiver at distance d; the camera at distance D sees that
as d a / D radians. A thing at distance b behind the object, seen through it from distance c, moves by a b / (b + c).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.vector import Vec, length, subtract, unit
from vitrail.geometry.bounds import Bounds, bounds_of, plane_distance
from vitrail.geometry.placement import place
from vitrail.plan.view import View, plane_hits
from vitrail.scene.model import Object, Plane


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


def lever_on(view: View, source: Object, receiver: Object) -> Lever:
    """Light turned at ``source``, seen on ``receiver``."""
    origin, pixel_at = bounds_of(source), view.pixel_size_m
    target = _near_point(origin.centre, receiver) if origin.is_finite else view.position
    way = length(subtract(target, origin.centre)) if origin.is_finite else math.inf
    pixel = pixel_at(target)
    typical = way / pixel if pixel > 0 and math.isfinite(way) else 1 / view.pixel_angle
    return Lever(typical, _most_on(view, origin, receiver), f"on `{receiver.name}`")


def lever_through(view: View, source: Object) -> Lever:
    """What is seen in or through ``source``: at worst everything behind it is far away, and turns as the ray does."""
    if view.perspective:
        return Lever(1 / view.pixel_angle, 1 / view.pixel_angle, "in what is seen in or through it", True)
    return Lever(math.inf, math.inf, "in what is seen in or through it", True)


def _most_on(view: View, origin: Bounds, receiver: Object) -> float:
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


def _nearest_m(point: Vec, item: Object) -> float:
    """A distance that no point of an object falls below."""
    shape = place(item).shape
    if isinstance(shape, Plane):
        return abs(plane_distance(shape, point))
    bounds = bounds_of(item)
    if not bounds.is_finite:
        return 0.0
    outside = [max(low - p, p - high, 0.0) for low, p, high in zip(bounds.low, point, bounds.high, strict=True)]
    return math.hypot(*outside)


def _near_point(point: Vec, item: Object) -> Vec:
    """A typical point of a receiver: the foot on a plane, the middle of anything else."""
    shape = place(item).shape
    if isinstance(shape, Plane):
        normal, height = unit(shape.normal), plane_distance(shape, point)
        return subtract(point, (normal[0] * height, normal[1] * height, normal[2] * height))
    bounds = bounds_of(item)
    return bounds.centre if bounds.is_finite else point


def _seen_points(view: View, item: Object) -> list[Vec]:
    """Corners of what an orthographic camera sees of a receiver."""
    shape = place(item).shape
    if isinstance(shape, Plane):
        return plane_hits(view, shape)
    bounds = bounds_of(item)
    return list(bounds.corners) if bounds.is_finite else []
