"""Scenes as a lowering that misunderstands them would read them; where a mistake has no say, nothing is changed."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from vitrail.base.changed import changed, unchecked
from vitrail.base.colour import Triplet, times
from vitrail.scene.model import Area, Directional, Light, Material, Object, Rectangle, Scene, Sphere, Transport

Misreading = Callable[[Scene], Scene]
Fields = Mapping[str, object]
"""Fields of a material by name, as they are misread."""


def materials(change: Callable[[Material], Fields]) -> Misreading:
    """Replace fields of every material; what ``change`` returns may be empty, and may break the rules of a scene."""

    def misread(scene: Scene) -> Scene:
        wrong = {name: unchecked(material, **change(material)) for name, material in scene.materials.items()}
        return unchecked(scene, materials=wrong)

    return misread


def glass(change: Callable[[Material], Fields]) -> Misreading:
    """Replace fields of transmissive materials only."""
    return materials(lambda material: change(material) if material.is_transmissive else {})


def lights(change: Callable[[Light], Light]) -> Misreading:
    return lambda scene: changed(scene, lights=tuple(change(light) for light in scene.lights))


def objects(change: Callable[[Object], Object]) -> Misreading:
    return lambda scene: changed(scene, objects=tuple(change(item) for item in scene.objects))


def transport(**changes: object) -> Misreading:
    def misread(scene: Scene) -> Scene:
        return changed(scene, transport=Transport.model_validate({**scene.transport.model_dump(), **changes}))

    return misread


def power(colour: Triplet, exponent: float) -> Triplet:
    return (colour[0] ** exponent, colour[1] ** exponent, colour[2] ** exponent)


def with_index(factor: float) -> Callable[[Material], Fields]:
    return lambda material: {} if material.ior is None or material.ior == 1 else {"ior": material.ior * factor}


def with_dispersion(factor: float) -> Callable[[Material], Fields]:
    """Scale the step between bands about the mean index of four, so that only the spread changes."""

    def change(material: Material) -> Fields:
        if not isinstance(material.dispersion, float) or material.ior is None:
            return {}
        return {
            "dispersion": material.dispersion * factor,
            "ior": material.ior + 1.5 * material.dispersion * (1 - factor),
        }

    return change


def with_absorption(factor: float) -> Callable[[Material], Fields]:
    return lambda material: (
        {} if material.absorption_per_m is None else {"absorption_per_m": times(material.absorption_per_m, factor)}
    )


def with_roughness(factor: float) -> Callable[[Material], Fields]:
    return lambda material: {"roughness": material.roughness * factor} if isinstance(material.roughness, float) else {}


def turned_sun(angle: float) -> Misreading:
    """Directional lights turned by ``angle`` radians about the z axis."""

    def change(light: Light) -> Light:
        emitter = light.emitter
        if not isinstance(emitter, Directional):
            return light
        x, y, z = emitter.direction
        sine, cosine = math.sin(angle), math.cos(angle)
        turned = changed(emitter, direction=(x * cosine - y * sine, x * sine + y * cosine, z))
        return changed(light, emitter=turned)

    return lights(change)


def moved_balls(metres: float) -> Misreading:
    """Balls ``metres`` aside, along x."""

    def change(item: Object) -> Object:
        if not isinstance(item.shape, Sphere):
            return item
        x, y, z = item.shape.center
        return changed(item, shape=changed(item.shape, center=(x + metres, y, z)))

    return objects(change)


def smaller_lamps(factor: float) -> Misreading:
    """Area lights shrunk to ``factor`` of their edges, with the same power."""

    def change(light: Light) -> Light:
        emitter = light.emitter
        if not isinstance(emitter, Area) or not isinstance(emitter.shape, Rectangle) or emitter.radiance is None:
            return light
        shape = emitter.shape
        smaller = changed(shape, u=times(shape.u, factor), v=times(shape.v, factor))
        brighter = times(emitter.radiance, factor**-2)
        return changed(light, emitter=changed(emitter, shape=smaller, radiance=brighter))

    return lights(change)


def brighter_suns(factor: float) -> Misreading:
    """Every directional light ``factor`` times as bright."""

    def change(light: Light) -> Light:
        emitter = light.emitter
        if not isinstance(emitter, Directional):
            return light
        return changed(light, emitter=changed(emitter, irradiance=times(emitter.irradiance, factor)))

    return lights(change)
