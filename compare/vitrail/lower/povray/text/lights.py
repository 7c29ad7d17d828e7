"""Lights in POV-Ray's units: irradiance over pi, and the inverse square by a tiny ``fade_distance``.

POV-Ray's Lambert surface has no 1/pi, so an irradiance E is the colour E / pi [P 1.1]. Its only falloff is
2 / (1 + (r / f)^2), which for f << r is 2 f^2 / r^2 with the relative error (f / r)^2 [P 1.2]. Lights with a surface or
a solid angle are a grid of small ones (``emitters.py``), because POV-Ray's area light has no cosine, wrong weights and
wrong photons [P 1.4].
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import assert_never

from vitrail.base.colour import Triplet, times
from vitrail.base.vector import Vec, add, cross, length, scale, unit
from vitrail.geometry.placement import solid_of
from vitrail.lower.povray.asked import Asked
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.refusals.refusal import NotTranslatable
from vitrail.lower.povray.text.emitters import (
    Emitter,
    Grid,
    disc_points,
    rectangle_points,
    sphere_directions,
    sun_directions,
)
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.sdl import Block, Statement, block, rgb, statement, vector
from vitrail.lower.povray.text.shapes import aperture
from vitrail.lower.povray.text.sky import Skies
from vitrail.lower.povray.text.wide_lamps import COARSEST, MOST_LIGHTS, closeness
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Area, Directional, Disc, Environment, Light, Point, Rectangle, Spot

SUN_DISTANCE = 16384.0
"""Units from the origin to the plane of a parallel light: beyond every scene, well below the limit of 1e7 [P 1.3]."""
FADE_SHARE = 1e-3
"""fade_distance over the distance to the nearest surface: the inverse square then errs by at most 1e-6."""
NEAREST_SURFACE = 1e-3
"""Units; a surface nearer to a light than this is ignored by POV-Ray's shadow rays [P 7]."""


@dataclass(frozen=True)
class Cone:
    """Where a lamp at a point shines: within ``half_angle_deg`` of ``axis``, with the cosine where ``is_lambert``."""

    axis: Vec
    half_angle_deg: float
    is_lambert: bool


@dataclass(frozen=True)
class Source:
    """One POV-Ray light: at ``position`` (units), or parallel along ``direction``.

    ``strength`` is what its photons carry: E / pi, or I / pi in units, along the axis of a cone. ``aperture`` is the
    shape that parallel light must pass. ``light`` is the index of the scene's light it belongs to, and ``aside`` how
    far it stands from where that has it, units. ``step`` is how far the lights of a lamp stand apart, over the distance
    of what they light.
    """

    light: int
    strength: Triplet
    position: Vec
    direction: Vec | None = None
    fade_distance: float | None = None
    cone: Cone | None = None
    aperture: Block | None = None
    aperture_area: float = math.inf
    aside: float = 0.0
    step: float = 0.0


def sources(asked: Asked, units: Normalisation, grid: Grid, skies: Skies) -> tuple[Source, ...]:
    """The lights of a scene as POV-Ray lights, a grid for each that is no point; raises NotTranslatable."""
    refused: list[Diagnostic] = []
    found: list[Source] = []
    for index, light in enumerate(asked.scene.lights):
        try:
            own = replace(grid, seed=grid.seed + index)
            found += _sources(light, index, asked, units, own, skies)
        except NotTranslatable as error:
            refused += error.diagnostics
    if refused:
        raise NotTranslatable(refused)
    return tuple(found)


def _sources(light: Light, index: int, asked: Asked, units: Normalisation, grid: Grid, skies: Skies) -> list[Source]:
    emitter = light.emitter
    match emitter:
        case Directional():
            parts = [Emitter((0.0, 0.0, 0.0), unit(emitter.direction), 1.0)]
            if emitter.angular_diameter_deg > 0:
                parts = sun_directions(unit(emitter.direction), emitter.angular_diameter_deg, grid)
            return [_parallel(index, emitter.irradiance, part) for part in parts]
        case Point():
            fade = _fade(light, index, emitter.position, asked, units)
            strength = times(emitter.intensity, units.scale**2 / math.pi)
            return [Source(index, strength, units.point(emitter.position), fade_distance=fade)]
        case Spot():
            fade = _fade(light, index, emitter.position, asked, units)
            strength = times(emitter.intensity, units.scale**2 / math.pi)
            cone = Cone(unit(emitter.direction), emitter.cone_deg / 2, is_lambert=False)
            return [Source(index, strength, units.point(emitter.position), fade_distance=fade, cone=cone)]
        case Area() if emitter.collimated:
            return [_collimated(index, emitter, units)]
        case Area():
            return _patch(light, index, emitter, asked, units, grid)
        case Environment():
            if emitter.radiance is None:
                return [
                    _parallel(index, irradiance, Emitter((0.0, 0.0, 0.0), way, 1.0))
                    for way, irradiance in skies[index].directions(grid)
                ]
            # Each direction brings radiance times its solid angle.
            radiance = times(emitter.radiance, 4 * math.pi)
            return [_parallel(index, radiance, part) for part in sphere_directions(grid)]
        case _:
            assert_never(emitter)


def _parallel(index: int, irradiance: Triplet, part: Emitter) -> Source:
    strength = times(irradiance, part.share / math.pi)
    return Source(index, strength, scale(part.direction, -SUN_DISTANCE), part.direction)


def _collimated(index: int, lamp: Area, units: Normalisation) -> Source:
    """Parallel light from far behind the lamp that must pass through its outline."""
    shape = lamp.shape
    normal = unit(shape.normal if isinstance(shape, Disc) else cross(shape.u, shape.v))
    middle = units.point(shape.center)
    start = add(middle, scale(normal, -SUN_DISTANCE))
    strength, area = times(lamp.strength, 1 / math.pi), area_of(shape) * units.scale**2
    return Source(index, strength, start, normal, aperture=aperture(shape, units), aperture_area=area)


def _patch(
    light: Light,
    index: int,
    lamp: Area,
    asked: Asked,
    units: Normalisation,
    grid: Grid,
) -> list[Source]:
    """One-sided Lambertian points on the lamp: I = radiance * area * cosine, shared."""
    shape = lamp.shape
    parts = _parts(shape, grid)
    close = closeness(solid_of(shape), area_of(shape), parts, asked.world.solids)
    if close.wanted > len(parts):
        parts = _parts(shape, replace(grid, count=min(close.wanted, MOST_LIGHTS)))
    if close.step(len(parts)) > COARSEST:
        what = (
            f"`{light.name}` is so wide and lights what is so near, {close.nearest_m:.3g} m, that it needs some"
            f" {close.wanted} small lights in POV-Ray; there are at most {MOST_LIGHTS}"
        )
        remedy = "move it away, make it smaller, or render it with the tracer alone"
        raise NotTranslatable([asked.refusals.at(what, remedy, "lights", index, light.emitter.key)])
    strength = times(lamp.strength, area_of(shape) * units.scale**2 / math.pi)
    found = []
    for part in parts:
        fade = _fade(light, index, part.position, asked, units)
        cone = Cone(part.direction, 90.0, is_lambert=True)
        position = units.point(part.position)
        strength_of_part, step = times(strength, part.share), close.step(len(parts))
        found.append(Source(index, strength_of_part, position, fade_distance=fade, cone=cone, step=step))
    return found


def _parts(shape: Rectangle | Disc, grid: Grid) -> list[Emitter]:
    return disc_points(shape, grid) if isinstance(shape, Disc) else rectangle_points(shape, grid)


def area_of(shape: Rectangle | Disc) -> float:
    """Square metres of one side of a lamp."""
    return math.pi * shape.radius**2 if isinstance(shape, Disc) else 4 * length(shape.u) * length(shape.v)


def _fade(light: Light, index: int, position: Vec, asked: Asked, units: Normalisation) -> float:
    """The fade distance of a lamp, units, from its nearest surface."""
    nearest = min((solid.distance(position) for solid in asked.world.solids), default=1 / units.scale)
    reach = units.length(nearest)
    if reach <= NEAREST_SURFACE:
        what = f"the lamp is {nearest:.3g} m from a surface, nearer than POV-Ray's shadow rays can tell"
        remedy = "move the lamp away from the surface"
        raise NotTranslatable([asked.refusals.at(what, remedy, "lights", index, light.emitter.key)])
    return FADE_SHARE * reach


def light_sdl(source: Source, exposure: Exposure) -> Block:
    """The ``light_source`` block of one run."""
    strength = exposure.light(source.strength)
    if source.direction is not None:
        # Keep this order of the words: the parser refuses point_at before parallel [P 1.3].
        aim = add(source.position, scale(source.direction, SUN_DISTANCE))
        passing = block("projected_through", source.aperture) if source.aperture else None
        head = statement(vector(source.position), rgb(strength))
        return block("light_source", head, statement("parallel"), statement("point_at", vector(aim)), passing)
    assert source.fade_distance is not None
    fade = source.fade_distance
    return block(
        "light_source",
        statement(vector(source.position), rgb(times(strength, 1 / (2 * fade * fade)))),
        statement("fade_distance", fade),
        statement("fade_power", 2),
        _cone_sdl(source.cone, source.position) if source.cone else None,
    )


def _cone_sdl(cone: Cone, position: Vec) -> Statement:
    """A sharp cone, or with tightness 1 the cosine of a one-sided Lambertian lamp [P 1.5]."""
    angle, tightness = cone.half_angle_deg, 1 if cone.is_lambert else 0
    words = ("spotlight", "radius", angle, "falloff", angle, "tightness", tightness)
    return statement(*words, "point_at", vector(add(position, cone.axis)))
