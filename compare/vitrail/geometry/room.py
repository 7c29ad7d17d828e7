"""A closed object with the camera and a lamp inside is a room: its inner face is the scene."""

from __future__ import annotations

from vitrail.base.vector import Vec
from vitrail.geometry.inside import contains
from vitrail.scene.model import Area, Directional, Environment, Light, Object, Point, Scene, Spot


def is_room(scene: Scene, item: Object) -> bool:
    """Whether an object holds the camera and at least one lamp."""
    places = [place for light in scene.lights if (place := place_of(light)) is not None]
    return contains(item, scene.camera.position) and any(contains(item, place) for place in places)


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
