"""How much of a light's power an object can take at most, from the sphere around it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import assert_never

from vitrail.base.vector import length, subtract
from vitrail.geometry.bounds import Bounds
from vitrail.scene.model import Area, Directional, Disc, Environment, Light, Point, Rectangle, Spot


def intercepted_power(light: Light, bounds: Bounds) -> float | None:
    """Watts, mean of the channels, an upper bound; None where none can be named."""
    if not bounds.is_finite:
        return None
    radius = bounds.radius_m
    emitter = light.emitter
    match emitter:
        case Directional():
            return _mean(emitter.irradiance) * math.pi * radius * radius
        case Point() | Spot():
            return _mean(emitter.intensity) * _solid_angle(length(subtract(bounds.centre, emitter.position)), radius)
        case Area():
            return _area_power(emitter)
        case Environment():
            if emitter.radiance is None:
                return None
            return _mean(emitter.radiance) * math.pi * 4 * math.pi * radius * radius
        case _:
            assert_never(emitter)


def _area_power(lamp: Area) -> float:
    """All that the lamp gives: pi L A, or E A when it is collimated."""
    match lamp.shape:
        case Rectangle() as shape:
            area = 4 * length(shape.u) * length(shape.v)
        case Disc() as shape:
            area = math.pi * shape.radius**2
        case _:
            assert_never(lamp.shape)
    return _mean(lamp.strength) * area if lamp.collimated else math.pi * _mean(lamp.strength) * area


def _solid_angle(distance: float, radius: float) -> float:
    """Of a sphere seen from a distance; everything from inside it."""
    if distance <= radius:
        return 4 * math.pi
    sine = radius / distance
    return 2 * math.pi * sine * sine / (1 + math.sqrt((1 - sine) * (1 + sine)))


def _mean(value: Sequence[float]) -> float:
    return sum(value) / max(len(value), 1)
