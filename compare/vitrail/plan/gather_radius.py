"""The radius of the photon kernel: as fine as what is looked at, as coarse as the photons allow."""

from __future__ import annotations

import math

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.patch import bounds_of_patch
from vitrail.geometry.world import World
from vitrail.plan.plan import Plan
from vitrail.plan.sampling import pixel_area_m2
from vitrail.scene.model import Patch

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


def gather_radius_m(world: World, plan: Plan, photons: int, *, views: bool = False) -> float:
    """The radius of the photon kernel, metres, with a short mantissa.

    It follows from the smallest observed caustic patch and the pixels on it, else from the smallest object that casts a
    caustic, else from the scene. With ``views`` every patch has the pixels that it needs, and only its size counts. The
    mantissa is rounded to three bits: a scene scaled by 2^k gets exactly 2^k times the radius, and the number prints
    short.
    """
    scene = world.scene
    patches = [item.patch for item in scene.observe if item.phenomenon == Phenomenon.CAUSTIC]
    casters = {path.specular for path in plan.caustic_paths}
    sizes = [world.bounds(item).radius_m for item in scene.objects if item.name in casters]
    if patches:
        radius = min(_radius_on(patch) if views else _radius_seen_on(world, patch) for patch in patches)
    elif any(math.isfinite(size) for size in sizes):
        radius = min(sizes) * OBJECT_SHARE
    else:
        radius = world.extent.radius_m * SCENE_SHARE
    return _short(radius * (USUAL_PHOTONS / max(photons, 1)) ** (1 / 6) if photons else radius)


def _radius_on(patch: Patch) -> float:
    """The radius that shows a patch as fine as it is."""
    return bounds_of_patch(patch).radius_m * PATCH_SHARE


def _radius_seen_on(world: World, patch: Patch) -> float:
    """The radius that shows a patch as fine as it, and the picture, can be seen."""
    return max(_radius_on(patch), math.sqrt(pixel_area_m2(world.view, patch)) * PIXEL_SHARE)


def _short(value: float) -> float:
    """The nearest number with a mantissa of three bits; commutes with powers of two."""
    mantissa, exponent = math.frexp(value)
    return math.ldexp(round(mantissa * 8) / 8, exponent)
