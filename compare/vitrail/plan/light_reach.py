"""Which light may reach which object: refused only where geometry proves it impossible."""

from __future__ import annotations

import math
from typing import assert_never

from vitrail.base.vector import Vec, cross, dot, length, subtract, unit
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.solid import Solid
from vitrail.scene.model import Area, Directional, Disc, Environment, Light, Plane, Point, Rectangle, Spot

ANGLE_SLACK = 1e-9
"""Radians added to every cone before it is used as a proof of darkness."""


def is_lit(light: Light) -> bool:
    """Whether a light gives any light at all; an environment image counts as bright."""
    emitter = light.emitter
    match emitter:
        case Directional():
            return max(emitter.irradiance) > 0
        case Point() | Spot():
            return max(emitter.intensity) > 0
        case Area():
            return max(emitter.strength) > 0
        case Environment():
            return emitter.radiance is None or max(emitter.radiance) > 0
        case _:
            assert_never(emitter)


def may_reach(light: Light, solid: Solid) -> bool:
    """Whether light may fall on a solid, ignoring what stands in between."""
    if not is_lit(light):
        return False
    bounds, emitter = solid.bounds, light.emitter
    match emitter:
        case Directional():
            return not (isinstance(solid, PlacedPlane) and _is_edge_on(emitter, solid.shape))
        case Point() | Environment():
            return True
        case Spot():
            return _in_cone(emitter, bounds)
        case Area():
            return _in_front(emitter, bounds)
        case _:
            assert_never(emitter)


def _is_edge_on(sun: Directional, plane: Plane) -> bool:
    return sun.angular_diameter_deg == 0 and dot(unit(sun.direction), unit(plane.normal)) == 0


def _in_cone(spot: Spot, bounds: Bounds) -> bool:
    """The sphere around the box, seen from the lamp, against the cone."""
    if not bounds.is_finite:
        return True
    away = subtract(bounds.centre, spot.position)
    distance = length(away)
    if distance <= bounds.radius_m:
        return True
    off_axis = _angle(away, spot.direction)
    return off_axis <= math.radians(spot.cone_deg) / 2 + math.asin(bounds.radius_m / distance) + ANGLE_SLACK


def _in_front(lamp: Area, bounds: Bounds) -> bool:
    """Some corner lies on the side to which the lamp shines, and inside the beam if it is collimated."""
    if not bounds.is_finite:
        return True
    centre, normal, reach = _emitting_face(lamp)
    heights = [dot(normal, subtract(corner, centre)) for corner in bounds.corners]
    if max(heights) <= 0:
        return False
    if not lamp.collimated:
        return True
    away = subtract(bounds.centre, centre)
    beside = length(cross(normal, away))
    return beside <= (reach + bounds.radius_m) * (1 + ANGLE_SLACK)


def _emitting_face(lamp: Area) -> tuple[Vec, Vec, float]:
    """Centre, unit normal and the radius of the circle around the lamp."""
    match lamp.shape:
        case Rectangle() as shape:
            return shape.center, unit(cross(shape.u, shape.v)), math.hypot(length(shape.u), length(shape.v))
        case Disc() as shape:
            return shape.center, unit(shape.normal), shape.radius
        case _:
            assert_never(lamp.shape)


def _angle(a: Vec, b: Vec) -> float:
    """Angle between two vectors, exact for small ones too."""
    return math.atan2(length(cross(a, b)), dot(a, b))
