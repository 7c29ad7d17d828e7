"""Where lamps are: the place and the room of an emitter."""

from __future__ import annotations

from typing import assert_never

from vitrail.base.vector import Vec
from vitrail.geometry.bounds import EVERYWHERE, Bounds
from vitrail.geometry.placement import solid_of
from vitrail.scene.model import Area, Directional, Environment, Light, Point, Spot


def place_of(light: Light) -> Vec | None:
    """Where a lamp is, the middle of its shape for an area light; None for sun and sky."""
    emitter = light.emitter
    match emitter:
        case Point() | Spot():
            return emitter.position
        case Area():
            return emitter.shape.center
        case Directional() | Environment():
            return None
        case _:
            assert_never(emitter)


def bounds_of_light(light: Light) -> Bounds:
    """The room an emitter takes; sun and sky count as infinite."""
    emitter = light.emitter
    match emitter:
        case Directional() | Environment():
            return EVERYWHERE
        case Point() | Spot():
            return Bounds(emitter.position, emitter.position)
        case Area():
            return solid_of(emitter.shape).bounds
        case _:
            assert_never(emitter)
