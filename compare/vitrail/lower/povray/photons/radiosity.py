"""Light between diffuse surfaces: POV-Ray's radiosity in the place of the global photon map.

Radiosity gathers at some points with many rays and interpolates between them; each further bounce is one level of
recursion. In a closed room of albedo 1/2 it gives 2.00 times the direct light, as it should [M]. Its rays see glowing
surfaces and the sky as light, which in a scene they are not, so both are refused beside it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.immersion import index_around, partly_around
from vitrail.lower.povray.certificate.certificate import RELATIVE, Entry
from vitrail.lower.povray.refusals.refusal import Refusals
from vitrail.lower.povray.text.sdl import Block, block, statement
from vitrail.plan.settings import Quality
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Environment, Scene

RAYS: dict[Quality, int] = {Quality.DRAFT: 100, Quality.NORMAL: 200, Quality.REFERENCE: 800}
"""Rays a gathering point; the second half image has a few more, and so other ones."""
EXTRA_RAYS = {"a": 0, "b": 11}
ERROR_BOUND = 0.3
"""How far points may stand apart for their curvature; smaller is slower and less smooth."""
DEEPEST = 20
"""POV-Ray's own limit of recursion."""
SMALLEST_SHARE = 1e-3
"""Light that is left after the last bounce, relative."""


def bounces(scene: Scene) -> int:
    """Bounces until the most reflecting diffuse surface has let all but a thousandth go."""
    albedo = max((max(material.diffuse_peak) for material in scene.materials.values()), default=0.0)
    if albedo >= 1:
        return DEEPEST
    return max(1, min(DEEPEST, math.ceil(math.log(SMALLEST_SHARE) / math.log(max(albedo, 1e-3)))))


def radiosity_sdl(scene: Scene, quality: Quality, half: str) -> Block:
    """The block of ``global_settings``."""
    return block(
        "radiosity",
        statement("pretrace_start", 0.08),
        statement("pretrace_end", 0.01),
        statement("count", RAYS[quality] + EXTRA_RAYS[half]),
        statement("nearest_count", 8),
        statement("error_bound", ERROR_BOUND),
        statement("recursion_limit", bounces(scene)),
        statement("gray_threshold", 0),
        statement("adc_bailout", 0.0001),
        statement("brightness", 1),
    )


def radiosity_refusals(world: World, refusals: Refusals) -> Iterator[Diagnostic]:
    """What radiosity would count as light although the scene does not, or twice."""
    scene = world.scene
    for name, material in scene.materials.items():
        if material.emission is not None:
            what = "POV-Ray's radiosity would let this emission light other surfaces, which in a scene it does not"
            yield refusals.at(what, "use a light, or `indirect: {ambient: ...}`", "materials", name, "emission")
    for index, light in enumerate(scene.lights):
        if isinstance(light.emitter, Environment):
            what = "POV-Ray's radiosity would count the environment twice"
            yield refusals.at(what, "use other lights, or `indirect: {ambient: ...}`", "lights", index, "environment")
    covered = {other for _, other in world.contacts}
    for index, item in enumerate(scene.objects):
        is_in_glass = index in covered or index_around(world, index) != 1 or _is_partly_in_glass(world, index)
        if scene.material_of(item).is_diffuse and is_in_glass:
            what = "POV-Ray's radiosity would see this surface inside glass without the square of the index"
            yield refusals.at(
                what, "leave a millimetre between it and the glass, or use `indirect: {ambient: ...}`", "objects", index
            )


def _is_partly_in_glass(world: World, index: int) -> bool:
    return not world.material(index).is_transmissive and bool(partly_around(world, index))


def radiosity_entries(scene: Scene, quality: Quality) -> Iterator[Entry]:
    albedo = max((max(material.diffuse_peak) for material in scene.materials.values()), default=0.0)
    yield Entry(
        Phenomenon.INDIRECT_LIGHT,
        "radiosity",
        "every bounce, from a photon map",
        f"{bounces(scene)} bounces, {RAYS[quality]} rays at points {ERROR_BOUND:g} apart",
        albedo ** (bounces(scene) + 1) + 1 / math.sqrt(RAYS[quality]) / 4,
        RELATIVE,
        "rays are stratified and points are averaged; corners and contact shadows are smoother than they are",
    )
