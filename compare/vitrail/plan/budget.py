"""How much work a rendering may do: samples, photons, the gather radius, and what they follow from."""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.changed import changed
from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.patch import bounds_of_patch
from vitrail.geometry.world import World
from vitrail.plan.plan import Plan
from vitrail.plan.sampling import pixel_area_m2, samples_for
from vitrail.plan.settings import Quality, ReferenceMode, Settings, Solver, read_settings
from vitrail.scene.model import Patch, Scene

PATCH_SHARE = 1 / 120
"""Gather radius over the half diagonal of an observed caustic: a disc of that size blurs the steep centre of a ball
lens (annuli of 1/24 of the patch) by 0.6 %, one twice as large by 2.2 %."""

PIXEL_SHARE = 1 / 2
"""Least gather radius over the edge of a pixel on the patch: what is finer no picture of that size shows, and a disc of
a tenth of a pixel costs a hundred times the photons, and samples enough to find it, for the same noise."""

OBJECT_SHARE = 1 / 40
"""Gather radius over the radius of the smallest glass that makes a caustic, where no patch says how fine to look."""

SCENE_SHARE = 1 / 200
"""Gather radius over the radius of the scene, where only planes and unbounded things are in it."""

USUAL_PHOTONS = 1_000_000
"""The number for which the shares above balance blur against noise; the radius follows photons^(-1/6) from there."""


@dataclass(frozen=True)
class _Level:
    samples: int
    photons: int
    final_gather_rays: int


_LEVELS: dict[Quality, _Level] = {
    Quality.DRAFT: _Level(samples=1, photons=100_000, final_gather_rays=16),
    Quality.NORMAL: _Level(samples=4, photons=1_000_000, final_gather_rays=64),
    Quality.REFERENCE: _Level(samples=64, photons=10_000_000, final_gather_rays=256),
}


def settings_for(world: World, plan: Plan, quality: Quality = Quality.NORMAL, **overrides: object) -> Settings:
    """Settings for a scene at a quality; ``overrides`` replace any field by name, typed as text or as a number.

    A scene about its samples (``image.samples``) has them at every quality. A plan without a caustic and without
    indirect light gets no photons at all; one with an observed caustic gets the samples that resolve it. Raises Fault
    for an unknown field or a value out of range.
    """
    scene = world.scene
    asked = read_settings({**_usual(scene, plan, quality), **overrides})
    if "gather_radius_m" not in overrides:
        asked = changed(asked, gather_radius_m=gather_radius_m(world, plan, asked.photons))
    is_free = "samples" not in overrides and scene.image.samples is None and asked.quality is not Quality.DRAFT
    if is_free and plan.requires(Phenomenon.CAUSTIC):
        asked = changed(asked, samples=max(asked.samples, samples_for(world, asked.gather_radius_m)))
    return asked


def _usual(scene: Scene, plan: Plan, quality: Quality) -> dict[str, object]:
    """What holds where nobody asks for anything; the gather radius is a stand-in until the photons are known."""
    level = _LEVELS[quality]
    is_indirect = scene.transport.indirect == "photons"
    return {
        "quality": quality,
        "samples": scene.image.samples or level.samples,
        "photons": level.photons if is_indirect or plan.requires(Phenomenon.CAUSTIC) else 0,
        "gather_radius_m": 1.0,
        "seed": 1,
        "rough_samples": scene.paper.rough_samples,
        "final_gather_rays": level.final_gather_rays if is_indirect else 0,
        "memory_limit_mb": 4096,
        "solver": Solver.PHOTON_MAP,
        "reference_mode": ReferenceMode.AUTO,
    }


def gather_radius_m(world: World, plan: Plan, photons: int) -> float:
    """The radius of the photon kernel, metres, with a short mantissa.

    It follows from the smallest observed caustic patch and the pixels on it, else from the smallest object that casts a
    caustic, else from the scene. The mantissa is rounded to three bits: a scene scaled by 2^k gets exactly 2^k times
    the radius, and the number prints short.
    """
    scene = world.scene
    patches = [item.patch for item in scene.observe if item.phenomenon == Phenomenon.CAUSTIC]
    casters = {path.specular for path in plan.caustic_paths}
    sizes = [world.bounds(item).radius_m for item in scene.objects if item.name in casters]
    if patches:
        radius = min(_radius_on(world, patch) for patch in patches)
    elif any(math.isfinite(size) for size in sizes):
        radius = min(sizes) * OBJECT_SHARE
    else:
        radius = world.extent.radius_m * SCENE_SHARE
    return _short(radius * (USUAL_PHOTONS / max(photons, 1)) ** (1 / 6) if photons else radius)


def _radius_on(world: World, patch: Patch) -> float:
    """The radius that shows a patch as fine as it, and the picture, can be seen."""
    return max(bounds_of_patch(patch).radius_m * PATCH_SHARE, math.sqrt(pixel_area_m2(world.view, patch)) * PIXEL_SHARE)


def _short(value: float) -> float:
    """The nearest number with a mantissa of three bits; commutes with powers of two."""
    mantissa, exponent = math.frexp(value)
    return math.ldexp(round(mantissa * 8) / 8, exponent)
