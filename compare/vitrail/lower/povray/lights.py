"""Lights in POV-Ray's units: irradiance over pi, and the inverse square by a tiny ``fade_distance``.

POV-Ray's Lambert surface has no 1/pi, so an irradiance E is the colour E / pi [P 1.1]. Its only falloff is
2 / (1 + (r / f)^2), which for f << r is 2 f^2 / r^2 with the relative error (f / r)^2 [P 1.2].
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import assert_never

from vitrail.lower.povray.exposure import Exposure, Triplet
from vitrail.lower.povray.normalise import Normalisation
from vitrail.lower.povray.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.sdl import block, number, rgb, vector
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.distance import distance_to_surface
from vitrail.scene.model import Area, Directional, Environment, Light, Point, Scene, Spot
from vitrail.scene.vector import Vec, scale, unit

SUN_DISTANCE = 16384.0
"""Units from the origin to the plane of a parallel light: beyond every scene, well below the limit of 1e7 [P 1.3]."""
FADE_SHARE = 1e-3
"""fade_distance over the distance to the nearest surface: the inverse square then errs by at most 1e-6."""
NEAREST_SURFACE = 1e-3
"""Units; a surface nearer to a light than this is ignored by POV-Ray's shadow rays [P 7]."""


@dataclass(frozen=True)
class Source:
    """One POV-Ray light, at ``position`` or parallel along ``direction``; ``strength`` is E / pi or I / pi in units."""

    strength: Triplet
    position: Vec
    direction: Vec | None
    fade_distance: float | None


def sources(scene: Scene, normalisation: Normalisation, refusals: Refusals) -> tuple[Source, ...]:
    """The lights of a scene as POV-Ray emitters, at full light; raises NotTranslatable."""
    refused: list[Diagnostic] = []
    found: list[Source] = []
    for index, light in enumerate(scene.lights):
        try:
            found.append(_source(light, index, scene, normalisation, refusals))
        except NotTranslatable as error:
            refused += error.diagnostics
    if refused:
        raise NotTranslatable(refused)
    return tuple(found)


def _source(light: Light, index: int, scene: Scene, units: Normalisation, refusals: Refusals) -> Source:
    emitter = light.emitter
    match emitter:
        case Directional():
            direction = unit(emitter.direction)
            strength = _times(emitter.irradiance, 1 / math.pi)
            return Source(strength, scale(direction, -SUN_DISTANCE), direction, None)
        case Point():
            position = units.point(emitter.position)
            strength = _times(emitter.intensity, units.scale**2 / math.pi)
            return Source(strength, position, None, _fade(light, index, emitter.position, scene, units, refusals))
        case Spot() | Area() | Environment():
            what = f"a light of kind {light.kind} has no POV-Ray counterpart here yet"
            raise NotTranslatable([refusals.at(what, "use a directional or point light", "lights", index, light.kind)])
        case _:
            assert_never(emitter)


def _fade(light: Light, index: int, position: Vec, scene: Scene, units: Normalisation, refusals: Refusals) -> float:
    """The fade distance of a lamp, units, from its nearest surface."""
    distances = [distance_to_surface(item, position) for item in scene.objects]
    nearest = min((distance for distance in distances if distance is not None), default=1 / units.scale)
    reach = units.length(nearest)
    if reach <= NEAREST_SURFACE:
        what = f"the lamp is {nearest:.3g} m from a surface, nearer than POV-Ray's shadow rays can tell"
        raise NotTranslatable([refusals.at(what, "move the lamp away from the surface", "lights", index, light.kind)])
    return FADE_SHARE * reach


def light_sdl(source: Source, exposure: Exposure) -> str:
    """The ``light_source`` block of one run."""
    strength = exposure.light(source.strength)
    if source.direction is not None:
        # Keep this order of the words: the parser refuses point_at before parallel [P 1.3].
        return block("light_source", [f"{vector(source.position)} {rgb(strength)}", "parallel", "point_at <0, 0, 0>"])
    assert source.fade_distance is not None
    fade = source.fade_distance
    colour = _times(strength, 1 / (2 * fade * fade))
    return block(
        "light_source",
        [f"{vector(source.position)} {rgb(colour)}", f"fade_distance {number(fade)}", "fade_power 2"],
    )


def _times(colour: Triplet, factor: float) -> Triplet:
    return (colour[0] * factor, colour[1] * factor, colour[2] * factor)
