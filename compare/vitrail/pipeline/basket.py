"""The cheapest samples and photons that bring the numbers of some views to their tolerances.

The variance of a number is a sum over causes: photons, of which a scene shoots one number for all views, and samples
of a pixel, of which every view has its own. ``photons`` times as many leave w / photons of the share w of photons;
``samples`` times as many leave (1 - w) / samples of the rest. A number that needs a variance ``factor`` times smaller
is decided where both together are 1 / factor. Of all such pairs the cheapest is taken.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from vitrail.base.record import number_in
from vitrail.judge.comparison import Comparison, ObservationResult, Verdict
from vitrail.judge.records import SceneResult
from vitrail.pipeline.prices import price_s

SAFETY = 1.3
"""The factor comes from an estimated interval, good to about 15 %; a little more spares another round."""

LEAST = 1.5
"""A look is taken with so many times the samples at least: the new interval is as good as the old to 15 % only."""

STEPS, FINER = 57, 2**0.25
"""Numbers of photons that are tried, and each over the one before: up to 16 000 times as many."""

MOST_PHOTONS = 50_000_000
"""Photons of a scene at most: the tracer's map of so many takes 2.7 GB, and a usual limit is 4."""

MOST_SAMPLES = 4096
"""Samples of a pixel of a view at most: 64 along each edge."""


@dataclass(frozen=True)
class Basket:
    """Times the photons of the scene and, by view, times the samples of a pixel, with their price in CPU seconds."""

    photons: float
    samples: Mapping[str, float]
    price_s: float


def levels(scene: SceneResult) -> dict[str, list[float]]:
    """By view, how much smaller the variance of each open number must be, ascending."""
    found: dict[str, list[float]] = {}
    for entry in scene.observations:
        found.setdefault(view_of(entry), []).extend(map(_factor, filter(can_decide, entry.comparisons)))
    return {name: sorted(factors) for name, factors in found.items() if factors}


def view_of(entry: ObservationResult) -> str:
    """The name of the picture in which an observation was measured; none for the scene's own."""
    return entry.view.name if entry.view is not None else ""


def samples_of(scene: SceneResult, view: str) -> int:
    """Samples of a pixel of a view, as it was rendered last."""
    own = int(number_in(scene.settings, "samples", 1.0))
    return next((entry.view.samples for entry in scene.observations if entry.view and entry.view.name == view), own)


def can_decide(comparison: Comparison) -> bool:
    return comparison.verdict is Verdict.INCONCLUSIVE and comparison.sample_factor is not None


def _factor(comparison: Comparison) -> float:
    return max(SAFETY * (comparison.sample_factor or 1.0), LEAST)


def photon_share(observations: list[ObservationResult]) -> float:
    """The share of photons in the variance of a view, both engines together; 0 where no noise is known."""
    causes = [each for entry in observations for each in entry.noise]
    whole = sum(each.photons + each.edges + each.rays for each in causes)
    return sum(each.photons for each in causes) / whole if whole > 0 else 0.0


def cheapest(scene: SceneResult, wanted: Mapping[str, float], *, fixed_samples: bool = False) -> Basket | None:
    """The cheapest basket that divides the variance of each view by its factor; None where none does."""
    shares = {name: photon_share([entry for entry in scene.observations if view_of(entry) == name]) for name in wanted}
    photons = number_in(scene.settings, "photons", 0.0)
    found = []
    for step in range(STEPS if photons else 1):
        times = FINER**step
        if photons and times > 1 and times * photons > MOST_PHOTONS:
            break
        samples = {name: _samples(factor, shares[name], times) for name, factor in wanted.items()}
        if all(_is_possible(scene, name, each, fixed_samples) for name, each in samples.items()):
            found.append(Basket(times, samples, price_s(scene.engines, times, samples)))
    return min(found, key=lambda basket: basket.price_s, default=None)


def _samples(factor: float, share: float, photons: float) -> float:
    """Times the samples of a view that bring its variance to 1 / factor, beside so many times the photons."""
    room = 1 / factor - share / photons
    return max((1 - share) / room, 1.0) if room > 0 else math.inf


def _is_possible(scene: SceneResult, name: str, times: float, fixed_samples: bool) -> bool:
    return times == 1 if fixed_samples else times * samples_of(scene, name) <= MOST_SAMPLES
