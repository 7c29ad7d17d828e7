"""Buy more samples where a verdict is in doubt, nowhere else, and never for more than was allowed.

The interval of a number shrinks with the square root of the samples, so each doubtful comparison says how many times
the samples would decide it. A look at the numbers is a test: the runs that may follow count as comparisons too, and the
false-alarm rate of the suite holds whatever the number of looks.

A look that cannot decide is money lost, so a scene whose price is above its bound buys nothing and says the price.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from vitrail.base.record import number_in
from vitrail.judge.comparison import Comparison, Verdict
from vitrail.judge.records import EngineRun, MoreSamples, SceneResult

SAFETY = 1.3
"""The factor comes from an estimated interval, good to about 15 %; a little more spares another round."""

LEAST = 2.0
"""A look that is worth its cost doubles the samples."""

GATHER_GROWTH = 2 / 3
"""A kernel of fixed photons^(-1/6) radius holds photons^(2/3) photons, each of which a gather adds up."""


def wanted_factor(scene: SceneResult) -> float | None:
    """How many times the samples would decide this scene; None where it is decided or samples cannot decide.

    One deviation decides a scene, so the cheapest number that seems to deviate asks; else all have to agree, and the
    most doubtful one asks.
    """
    if scene.verdict is not Verdict.INCONCLUSIVE:
        return None
    doubtful = [entry for observation in scene.observations for entry in observation.comparisons if _can_decide(entry)]
    outside = [entry.sample_factor or 1.0 for entry in doubtful if abs(entry.difference) > entry.tolerance]
    inside = [entry.sample_factor or 1.0 for entry in doubtful]
    if not inside:
        return None
    return max(SAFETY * (min(outside) if outside else max(inside)), LEAST)


def price_s(engines: Sequence[EngineRun], factor: float, *, fixed_samples: bool = False) -> float:
    """CPU seconds of one more look with ``factor`` times the samples and photons, from what the last look took.

    Shooting and sorting grow as the photons, camera rays as the samples unless the scene fixes those; where photons
    are gathered, each ray also finds more of them.
    """
    return sum(_engine_price_s(engine, factor, 1.0 if fixed_samples else factor) for engine in engines)


def offer(scene: SceneResult, left_s: float, budget_s: float, *, fixed_samples: bool = False) -> MoreSamples | None:
    """What deciding a scene in doubt costs, and whether the ``left_s`` of its ``budget_s`` pay for it."""
    if scene.verdict is not Verdict.INCONCLUSIVE:
        return None
    factor = wanted_factor(scene)
    if factor is None:
        return MoreSamples(budget_s=budget_s, affordable=False, reason="more samples cannot decide what is in doubt")
    price = price_s(scene.engines, factor, fixed_samples=fixed_samples)
    reason = (
        f"about {_short(factor)} times the samples would decide, for about {_short(price)} CPU s more;"
        f" {_short(left_s)} of the {_short(budget_s)} CPU s that one scene may cost beyond its first look are left"
    )
    return MoreSamples(factor=factor, cpu_s=price, budget_s=budget_s, affordable=price <= left_s, reason=reason)


def more(settings: Mapping[str, Any], factor: float, *, fixed_samples: bool = False) -> dict[str, object]:
    """The settings to replace for ``factor`` times the work of both kinds; samples that the scene fixes stay."""
    keys = ("photons",) if fixed_samples else ("samples", "photons")
    return {key: math.ceil(settings[key] * factor) for key in keys if settings.get(key)}


def _can_decide(comparison: Comparison) -> bool:
    return comparison.verdict is Verdict.INCONCLUSIVE and comparison.sample_factor is not None


def _engine_price_s(engine: EngineRun, factor: float, rays: float) -> float:
    """One engine's share. What is in no phase is taken as growing too: it is mostly reading and writing samples."""
    phases = engine.record.get("cpu_s")
    camera = sum(number_in(phases, name, 0.0) for name in ("camera", "gather")) if isinstance(phases, dict) else 0.0
    rest = max((engine.cpu_s or 0.0) - camera, 0.0)
    found = factor**GATHER_GROWTH if engine.photons_stored else 1.0
    return rest * factor + camera * rays * found


def _short(value: float) -> str:
    """Two digits where there are no more before the point."""
    return f"{value:.0f}" if value >= 10 else f"{value:.2g}"
