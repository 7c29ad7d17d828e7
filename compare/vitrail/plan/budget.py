"""How much work a rendering may do: the settings that follow from a plan and a quality."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from vitrail.base.changed import changed
from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.plan.gather_radius import gather_radius_m
from vitrail.plan.plan import Plan
from vitrail.plan.sampling import samples_for
from vitrail.plan.settings import Quality, ReferenceMode, Settings, Solver, read_settings
from vitrail.scene.model import Scene


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

BRANCH_SHARE = 0.01
"""The tracer follows both ways on from this share of a look on; measured in docs/decisions/0039."""

BRANCH_SHARE_OF_VIEWS = 1e-4
"""Where numbers are measured: four clear panes then have a noise of .02 % of the light, not .5 %, for five times the
rays, which in views are still cheap beside the other engine."""


def settings_for(world: World, plan: Plan, quality: Quality = Quality.NORMAL, **overrides: object) -> Settings:
    """Settings for a scene at a quality; ``overrides`` replace any field by name, typed as text or as a number.

    A scene about its samples (``image.samples``) has them at every quality. A plan without a caustic and without
    indirect light gets no photons at all; one with an observed caustic gets the samples that resolve it. Raises Fault
    for an unknown field or a value out of range.
    """
    asked = _asked(world, plan, quality, overrides, views=False)
    is_free = "samples" not in overrides and world.scene.image.samples is None and asked.quality is not Quality.DRAFT
    if is_free and plan.requires(Phenomenon.CAUSTIC):
        asked = changed(asked, samples=max(asked.samples, samples_for(world, asked.gather_radius_m)))
    return asked


def settings_for_views(world: World, plan: Plan, quality: Quality = Quality.NORMAL, **overrides: object) -> Settings:
    """As ``settings_for``, where each patch is observed in a view of its own.

    The pixels of the scene's picture then say nothing about the gather radius, nor about the samples of a pixel: those
    are the level's, and ``views`` adds to them where a caustic wants more. Raises Fault as ``settings_for`` does.
    """
    return _asked(world, plan, quality, {"branch_share": BRANCH_SHARE_OF_VIEWS, **overrides}, views=True)


def _asked(world: World, plan: Plan, quality: Quality, overrides: Mapping[str, object], *, views: bool) -> Settings:
    asked = read_settings({**_usual(world.scene, plan, quality), **overrides})
    if "gather_radius_m" in overrides:
        return asked
    return changed(asked, gather_radius_m=gather_radius_m(world, plan, asked.photons, views=views))


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
        "branch_share": BRANCH_SHARE,
        "reference_mode": ReferenceMode.AUTO,
    }
