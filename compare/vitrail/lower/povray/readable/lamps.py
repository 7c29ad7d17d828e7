"""The lights of a scene, one of POV-Ray's for each, with the strength that the author gave.

A lamp with an area is POV-Ray's ``area_light`` with the cosine of a Lambertian lamp [P 1.4]: its grid is drawn in by
half a cell at each side, because POV-Ray's samples stand on the very edge, and has a power of two, because only then
they count alike. A sun with a diameter and a sky are many parallel lights, which no artist reads: they stand in a file
beside.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from vitrail.base.colour import Triplet
from vitrail.base.vector import add, cross, scale, unit
from vitrail.geometry.surface import tangents
from vitrail.lower.povray.readable.identifiers import Identifiers, file_stem
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.lights import SUN_DISTANCE, Cone, Source, area_of, light_sdl
from vitrail.lower.povray.text.sdl import (
    Blank,
    Block,
    Comment,
    Declaration,
    Identifier,
    Include,
    Part,
    Product,
    Quoted,
    Quotient,
    SdlFile,
    Value,
    block,
    listed,
    rgb,
    statement,
    vector,
)
from vitrail.lower.povray.translation import Translation
from vitrail.scene.model import Area, Disc, Light

GRID, GRID_OF_PHOTONS = 8, 4
"""Samples along each edge of a lamp; fewer where each sample shoots photons of its own."""


@dataclass(frozen=True)
class Lamps:
    """The lights of a file; ``beside`` are files of lights that it includes."""

    parts: tuple[Part, ...]
    beside: dict[str, SdlFile]


def readable_lamps(translation: Translation, exposure: Exposure, identifiers: Identifiers, stem: str) -> Lamps:
    parts: list[Part] = []
    beside: dict[str, SdlFile] = {}
    for index, light in enumerate(translation.scene.lights):
        sources = [source for source in translation.lighting.halves["a"] if source.light == index]
        parts += [Blank(), Comment(f"{light.name}: {_described(light)}")]
        if isinstance(light.emitter, Area) and not light.emitter.collimated:
            parts += _area(translation, light, light.emitter, sources, exposure, identifiers)
        elif len(sources) == 1:
            parts += _single(translation, light, sources[0], exposure, identifiers)
        else:
            file = f"{stem}_{file_stem(light.name)}.inc"
            parts += [Comment(f"{len(sources)} parallel lights, each with its share"), Include(Quoted(file))]
            beside[file] = SdlFile(tuple(light_sdl(source, exposure) for source in sources))
    return Lamps(tuple(parts), beside)


def _described(light: Light) -> str:
    emitter = light.emitter
    if isinstance(emitter, Area):
        return "a lamp with an area, " + ("all its light along its normal" if emitter.collimated else "Lambertian")
    return {"directional": "parallel light", "point": "a lamp at a point", "spot": "a lamp with a sharp cone"}.get(
        emitter.key, f"an {emitter.key}"
    )


def _single(
    translation: Translation, light: Light, source: Source, exposure: Exposure, identifiers: Identifiers
) -> Iterator[Part]:
    """A parallel light, or a lamp at a point."""
    if source.direction is not None:
        # The strength of a source is its irradiance over pi.
        irradiance = identifiers.new(light.name, suffix="_Irradiance")
        yield Comment("irradiance on a surface that faces the light, W/m^2; POV-Ray's Lambert surface has no 1/pi")
        yield Declaration(irradiance, rgb(_times(exposure.light(source.strength), math.pi)))
        yield _parallel(source, irradiance)
        return
    area = translation.units.scale**2
    intensity, fade = identifiers.new(light.name, suffix="_Intensity"), identifiers.new(light.name, suffix="_Fade")
    yield Comment("intensity, W/sr" + ("" if area == 1 else f", times {area:g} for units of {1 / math.sqrt(area):g} m"))
    yield Declaration(intensity, rgb(_times(exposure.light(source.strength), math.pi)))
    yield Declaration(fade, _fade(source))
    yield _falling(source, intensity, fade, ())


def _parallel(source: Source, irradiance: Identifier) -> Block:
    assert source.direction is not None
    return block(
        "light_source",
        statement(Product(-SUN_DISTANCE, vector(source.direction))),
        statement("color", Quotient(irradiance, "pi")),
        statement("parallel"),
        statement("point_at", vector((0, 0, 0))),
        block("projected_through", source.aperture) if source.aperture is not None else None,
    )


def _falling(source: Source, intensity: Identifier, fade: Identifier, more: tuple[Part, ...]) -> Block:
    """The inverse square by a tiny fade distance [P 1.2]: the colour is what makes it the intensity far away."""
    cone = source.cone
    words: tuple[Value, ...] = ()
    if cone is not None:
        angle = cone.half_angle_deg
        words = ("spotlight", "radius", angle, "falloff", angle, "tightness", 1 if cone.is_lambert else 0)
        words = (*words, "point_at", vector(add(source.position, cone.axis)))
    below = Quotient(Quotient(Quotient(Quotient(intensity, 2), "pi"), fade), fade)
    return block(
        "light_source",
        statement(vector(source.position)),
        statement("color", below),
        Comment("falls with the square of the distance, but for a share of 1e-6 at the nearest surface"),
        statement("fade_distance", fade),
        statement("fade_power", 2),
        statement(*words) if words else None,
        *more,
    )


def _area(
    translation: Translation,
    light: Light,
    lamp: Area,
    sources: list[Source],
    exposure: Exposure,
    identifiers: Identifiers,
) -> Iterator[Part]:
    """One lamp in its middle, spread over the grid of an ``area_light``."""
    shape, units = lamp.shape, translation.units
    is_disc = isinstance(shape, Disc)
    u, v = tangents(shape.normal) if isinstance(shape, Disc) else (shape.u, shape.v)
    size = 2 * shape.radius if isinstance(shape, Disc) else 2.0
    normal = unit(cross(u, v))
    samples = GRID if translation.photons is None else GRID_OF_PHOTONS
    inner = (samples - 1) / samples
    middle = units.point(shape.center)
    edges = [vector(units.vector(scale(edge, size * inner))) for edge in (u, v)]
    # All small lights of a lamp have one strength: its intensity along the normal over pi, shared.
    strength = _times(sources[0].strength, len(sources) * math.pi)
    source = Source(
        sources[0].light,
        strength,
        middle,
        fade_distance=min(_fade(each) for each in sources),
        cone=Cone(normal, 90.0, is_lambert=True),
    )
    intensity, fade = identifiers.new(light.name, suffix="_Intensity"), identifiers.new(light.name, suffix="_Fade")
    square = units.scale**2
    radiance, area = _words(lamp.strength), area_of(shape)
    yield Comment(f"radiance {radiance} W/m^2/sr on {area:.6g} m^2; intensity along the normal, W/sr")
    if square != 1:
        yield Comment(f"times {square:g} for units of {1 / units.scale:g} m")
    yield Declaration(intensity, rgb(exposure.light(strength)))
    yield Declaration(fade, _fade(source))
    more = (
        statement("area_light", listed(*edges, samples, samples)),
        statement("circular") if is_disc else None,
        statement("area_illumination", "on"),
        statement("jitter"),
        block("photons", statement("area_light")) if translation.photons is not None else None,
    )
    yield _falling(source, intensity, fade, tuple(part for part in more if part is not None))


def _fade(source: Source) -> float:
    assert source.fade_distance is not None
    return source.fade_distance


def _words(colour: Triplet) -> str:
    red, green, blue = colour
    return f"{red:g}" if red == green == blue else f"<{red:g}, {green:g}, {blue:g}>"


def _times(colour: Triplet, factor: float) -> Triplet:
    return (colour[0] * factor, colour[1] * factor, colour[2] * factor)
