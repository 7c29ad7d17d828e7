"""The declared matrix: which settings of which engine are tried on a scene, and why.

Only knobs that the plan gives a meaning are turned: photons and gather radius where there is a caustic, bands where
there is dispersion, depth where chains have no proven end, samples where nothing else is random.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any, Literal, get_args

from vitrail.plan.plan import Plan
from vitrail.scene.phenomenon import Phenomenon

EngineName = Literal["tracer", "povray"]
Extent = Literal["quick", "normal", "wide"]

ENGINES: tuple[EngineName, ...] = get_args(EngineName)

PHOTONS: Mapping[Extent, Mapping[EngineName, tuple[int, ...]]] = {
    "quick": {"tracer": (10_000, 100_000, 1_000_000), "povray": (10_000, 100_000)},
    "normal": {"tracer": (10_000, 40_000, 160_000, 640_000, 2_560_000), "povray": (10_000, 40_000, 160_000, 640_000)},
    "wide": {
        "tracer": (10_000, 40_000, 160_000, 640_000, 2_560_000, 10_240_000),
        "povray": (10_000, 40_000, 160_000, 640_000, 2_560_000),
    },
}
RADII: Mapping[Extent, tuple[float, ...]] = {"quick": (1.0, 0.5), "normal": (1.0, 0.5, 0.25), "wide": (2, 1, 0.5, 0.25)}
"""Gather radius over the one the budget chooses for a million photons."""

SAMPLES: Mapping[Extent, tuple[int, ...]] = {"quick": (1, 4), "normal": (1, 4, 16), "wide": (1, 4, 16, 64)}
BANDS: tuple[Any, ...] = ("paper", {"spectral": 8}, {"spectral": 32})
DEPTHS: tuple[int, ...] = (2, 4, 8)
SEEDS: Mapping[Extent, int] = {"quick": 2, "normal": 3, "wide": 5}


@dataclass(frozen=True)
class Knobs:
    """One setting of one engine. ``settings`` override the budget, ``transport`` the scene's own wishes."""

    engine: EngineName
    settings: Mapping[str, Any]
    transport: Mapping[str, Any]
    seed: int

    @property
    def label(self) -> str:
        """The setting without its seed, for a table or a point of a chart."""
        parts = {**self.settings, **self.transport}
        return ", ".join(f"{name} {_short(value)}" for name, value in parts.items())


def matrix(plan: Plan, usual_radius_m: float, extent: Extent) -> list[Knobs]:
    """Every setting to try, cheap ones first, each engine by itself."""
    return [
        Knobs(engine, settings, transport, seed)
        for engine in ENGINES
        for settings in _settings(plan, usual_radius_m, extent, engine)
        for transport in _transports(plan, extent)
        for seed in _seeds(plan, extent, engine)
    ]


def _settings(plan: Plan, radius_m: float, extent: Extent, engine: EngineName) -> Iterator[dict[str, Any]]:
    """Photons and radius for a caustic, samples a pixel for anything else."""
    if not plan.requires(Phenomenon.CAUSTIC):
        yield from ({"samples": samples} for samples in SAMPLES[extent])
        return
    for photons, share in product(PHOTONS[extent][engine], RADII[extent]):
        yield {"samples": 1, "photons": photons, "gather_radius_m": radius_m * share}


def _transports(plan: Plan, extent: Extent) -> Iterator[dict[str, Any]]:
    if plan.requires(Phenomenon.DISPERSION):
        bands = BANDS[:2] if extent == "quick" else BANDS
        yield from ({"bands": each} for each in bands)
    elif not plan.chain.proven and plan.requires(Phenomenon.REFLECTION):
        yield from ({"max_reflections": depth} for depth in DEPTHS)
    else:
        yield {}


def _seeds(plan: Plan, extent: Extent, engine: EngineName) -> range:
    """POV-Ray has no seed; without a caustic nothing is random but the place of the samples."""
    if engine == "povray" or not plan.requires(Phenomenon.CAUSTIC):
        return range(1, 2)
    return range(1, 1 + SEEDS[extent])


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.3g}"
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\u2009")
    if isinstance(value, dict):
        return " ".join(f"{name} {each}" for name, each in value.items())
    return str(value)
