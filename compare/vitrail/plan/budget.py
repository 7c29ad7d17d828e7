"""How much work a rendering may do: samples, photons, the gather radius, and what they follow from."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Literal, get_args

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.bounds import bounds_of, bounds_of_patch, extent_of
from vitrail.geometry.world import World
from vitrail.plan.plan import Plan
from vitrail.plan.sampling import pixel_area_m2, samples_for
from vitrail.scene.model import Patch, Scene

Quality = Literal["draft", "normal", "reference"]
Solver = Literal["auto", "photon_map", "light_bins", "beams"]
ReferenceMode = Literal["auto", "native", "channels", "slices"]

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
class Settings:
    """Knobs of a rendering, the same for both engines; ``samples`` are per pixel, ``photons`` per scene."""

    quality: Quality
    samples: int
    photons: int
    gather_radius_m: float
    seed: int
    rough_samples: int
    final_gather_rays: int
    memory_limit_mb: int
    solver: Solver
    reference_mode: ReferenceMode


@dataclass(frozen=True)
class _Level:
    samples: int
    photons: int
    final_gather_rays: int


_LEVELS: dict[Quality, _Level] = {
    "draft": _Level(samples=1, photons=100_000, final_gather_rays=16),
    "normal": _Level(samples=4, photons=1_000_000, final_gather_rays=64),
    "reference": _Level(samples=64, photons=10_000_000, final_gather_rays=256),
}

QUALITIES: tuple[Quality, ...] = get_args(Quality)


def settings_for(world: World, plan: Plan, quality: Quality = "normal", **overrides: object) -> Settings:
    """Settings for a scene at a quality; ``overrides`` replace any field by name.

    A scene about its samples (``image.samples``) has them at every quality. A plan without a caustic and without
    indirect light gets no photons at all; one with an observed caustic gets the samples that resolve it. Raises
    ValueError for an unknown field or a value out of range.
    """
    scene, level = world.scene, _LEVELS[quality]
    needs_photons = plan.requires(Phenomenon.CAUSTIC) or scene.transport.indirect == "photons"
    settings = Settings(
        quality=quality,
        samples=scene.image.samples or level.samples,
        photons=level.photons if needs_photons else 0,
        gather_radius_m=0.0,
        seed=1,
        rough_samples=scene.paper.rough_samples,
        final_gather_rays=level.final_gather_rays if scene.transport.indirect == "photons" else 0,
        memory_limit_mb=4096,
        solver="photon_map",
        reference_mode="auto",
    )
    settings = override(settings, overrides)
    if settings.gather_radius_m == 0:
        settings = replace(settings, gather_radius_m=gather_radius_m(world, plan, settings.photons))
    is_free = "samples" not in overrides and scene.image.samples is None and settings.quality != "draft"
    if is_free and plan.requires(Phenomenon.CAUSTIC):
        settings = replace(settings, samples=max(settings.samples, samples_for(scene, settings.gather_radius_m)))
    return settings


def gather_radius_m(world: World, plan: Plan, photons: int) -> float:
    """The radius of the photon kernel, metres, with a short mantissa.

    It follows from the smallest observed caustic patch and the pixels on it, else from the smallest object that casts a
    caustic, else from the scene. The mantissa is rounded to three bits: a scene scaled by 2^k gets exactly 2^k times
    the radius, and the number prints short.
    """
    scene = world.scene
    patches = [item.patch for item in scene.observe if item.phenomenon == Phenomenon.CAUSTIC]
    casters = {path.specular for path in plan.caustic_paths}
    sizes = [bounds_of(item).radius_m for item in scene.objects if item.name in casters]
    if patches:
        radius = min(_radius_on(scene, patch) for patch in patches)
    elif any(math.isfinite(size) for size in sizes):
        radius = min(sizes) * OBJECT_SHARE
    else:
        radius = extent_of(scene).radius_m * SCENE_SHARE
    return _short(radius * (USUAL_PHOTONS / max(photons, 1)) ** (1 / 6) if photons else radius)


def _radius_on(scene: Scene, patch: Patch) -> float:
    """The radius that shows a patch as fine as it, and the picture, can be seen."""
    return max(bounds_of_patch(patch).radius_m * PATCH_SHARE, math.sqrt(pixel_area_m2(scene, patch)) * PIXEL_SHARE)


def _short(value: float) -> float:
    """The nearest number with a mantissa of three bits; commutes with powers of two."""
    mantissa, exponent = math.frexp(value)
    return math.ldexp(round(mantissa * 8) / 8, exponent)


# --- overrides ------------------------------------------------------------------------------------------------------

_CHOICES: dict[str, tuple[str, ...]] = {
    "quality": get_args(Quality),
    "solver": get_args(Solver),
    "reference_mode": get_args(ReferenceMode),
}
_LEAST: dict[str, int] = {"samples": 1, "rough_samples": 1, "memory_limit_mb": 1}


def setting_names() -> tuple[str, ...]:
    return tuple(item.name for item in fields(Settings))


def override(settings: Settings, overrides: dict[str, object]) -> Settings:
    """Settings with some fields replaced; raises ValueError that names the field, what is wrong and the remedy."""
    return replace(settings, **{key: _checked(key, value) for key, value in overrides.items()})  # type: ignore[arg-type]


def _checked(key: str, value: object) -> object:
    """One value in the type of its field."""
    if key not in setting_names():
        raise ValueError(f"there is no setting `{key}`; {_nearest(key)}")
    if key in _CHOICES:
        if value not in _CHOICES[key]:
            raise ValueError(f"`{key}` is {value!r}; choose one of {', '.join(_CHOICES[key])}")
        return value
    if key == "gather_radius_m":
        return _positive_metres(key, value)
    return _whole(key, value, _LEAST.get(key, 0))


def _nearest(key: str) -> str:
    from difflib import get_close_matches

    close = get_close_matches(key, setting_names(), n=1)
    return f"did you mean `{close[0]}`?" if close else f"the settings are {', '.join(setting_names())}"


def _whole(key: str, value: object, least: int) -> int:
    """A whole number; 1e6 is one too."""
    try:
        number = float(str(value))
    except ValueError:
        raise ValueError(f"`{key}` is {value!r}; write a whole number") from None
    if not (math.isfinite(number) and number == int(number)):
        raise ValueError(f"`{key}` is {value!r}; write a whole number")
    if number < least:
        raise ValueError(f"`{key}` is {value!r}; the least is {least}")
    return int(number)


def _positive_metres(key: str, value: object) -> float:
    try:
        number = float(str(value))
    except ValueError:
        raise ValueError(f"`{key}` is {value!r}; write a length in metres") from None
    if not (math.isfinite(number) and number > 0):
        raise ValueError(f"`{key}` is {value!r}; write a length in metres above 0")
    return number
