"""What the lights of POV-Ray do differently, as entries of the certificate."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.certificate.certificate import HALF_FLOAT, RELATIVE, Entry, the_light
from vitrail.lower.povray.text.lights import FADE_SHARE, Source
from vitrail.lower.povray.text.sky import Skies
from vitrail.lower.povray.text.wide_lamps import CLOSEST, ERROR
from vitrail.lower.povray.translation import Translation
from vitrail.scene.model import Directional, Scene

CLOSEST_AT_LAST = 1.2 * CLOSEST
"""A lattice has a Fibonacci number of points, up to a quarter less than is wanted."""


def light_entries(translation: Translation) -> Iterator[Entry]:
    """Falloff, grids of small lights, and the image of a sky."""
    scene, skies, lights = translation.scene, translation.lighting.skies, translation.lighting.halves["a"]
    yield from _falloff(scene, lights)
    yield from _grids(scene, lights, skies)
    yield from _coarse(scene, lights)
    if translation.photons is not None:
        yield from _focused(scene, lights)
    yield from _pixels(translation, skies)


def _falloff(scene: Scene, lights: Sequence[Source]) -> Iterator[Entry]:
    """Each small light of a grid loses the same share of its own light: one entry a light of the scene."""
    for index in sorted({source.light for source in lights if source.fade_distance is not None}):
        yield Entry(
            Phenomenon.DIFFUSION,
            the_light(scene, index),
            "E = I / r^2",
            "E = I / (r^2 + f^2)",
            FADE_SHARE**2,
            RELATIVE,
            "POV-Ray has no unbounded inverse square; f is 1/1000 of the distance to the nearest surface",
        )


def _grids(scene: Scene, lights: Sequence[Source], skies: Skies) -> Iterator[Entry]:
    """Lights with a surface or a solid angle, made of small ones."""
    for index, light in enumerate(scene.lights):
        count = sum(source.light == index for source in lights)
        if count > 1:
            measure = "power" if index in skies else "size"
            yield Entry(
                Phenomenon.SHADOW,
                the_light(scene, index),
                f"one {light.emitter.key} light",
                f"{count} small ones in each half image, a lattice of equal {measure} at a random place",
                1 / (2 * count),
                RELATIVE,
                "penumbras have steps of one small light; the light as a whole is unbiased",
            )


def _coarse(scene: Scene, lights: Sequence[Source]) -> Iterator[Entry]:
    """Lamps so wide beside the distance of what they light that the most small lights are still few."""
    for index in sorted({source.light for source in lights if source.step > CLOSEST_AT_LAST}):
        step = max(source.step for source in lights if source.light == index)
        for phenomenon in (Phenomenon.DIFFUSION, Phenomenon.SHADOW):
            yield Entry(
                phenomenon,
                the_light(scene, index),
                "light from every point of the lamp",
                f"from points {step:.2g} times as far apart as what they light is away",
                ERROR * step**2,
                RELATIVE,
                "where a surface is near, points are bright spots on it; root mean square under discs, measured",
            )


def _focused(scene: Scene, lights: Sequence[Source]) -> Iterator[Entry]:
    """A sun's image behind a lens: one spot for each small light. It widens no tolerance: what it does is noise."""
    for index, light in enumerate(scene.lights):
        count = sum(source.light == index for source in lights)
        if isinstance(light.emitter, Directional) and count > 1:
            diameter = math.radians(light.emitter.angular_diameter_deg)
            yield Entry(
                Phenomenon.CAUSTIC,
                the_light(scene, index),
                "the image of a sun is a disc",
                f"{count} spots in each half image, where glass focuses it",
                diameter / 2 * math.sqrt(math.pi / count),
                "m per metre of focal length",
                "how far they stand apart; gathering joins them where its disc is wider, the halves differ elsewhere",
            )


def _pixels(translation: Translation, skies: Skies) -> Iterator[Entry]:
    """The image of the sky as mirrors and glass show it; which pixel a direction meets is the same."""
    for index in skies:
        light = the_light(translation.scene, index)
        for phenomenon in (Phenomenon.REFLECTION, Phenomenon.REFRACTION):
            if translation.plan.requires(phenomenon):
                reason = "POV-Ray reads images with 11 bits a channel, and takes the nearest pixel as the tracer does"
                law = "pixels of half floats"
                yield Entry(phenomenon, light, "pixels as they are", law, HALF_FLOAT, RELATIVE, reason)
