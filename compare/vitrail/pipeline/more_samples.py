"""Buy what is missing where a number is open, cheapest first over all scenes, and never for more than was allowed.

A number in doubt says how much smaller its variance must be. ``basket`` finds the cheapest photons and samples for it,
in its view. A look at the numbers is a test: the looks that may follow count as comparisons too, and the false-alarm
rate of the suite holds whatever their number. A look that cannot decide is money lost, so what costs more than is left
is not begun, and its price is said.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from vitrail.base.record import number_in
from vitrail.judge.comparison import Verdict
from vitrail.judge.purchase import Purchase
from vitrail.judge.records import MoreSamples, SceneResult
from vitrail.pipeline.basket import Basket, can_decide, cheapest, levels, samples_of


@dataclass(frozen=True)
class _Step:
    """The next number that could be decided: in which view of which scene, and what that adds to the bill."""

    scene: str
    view: str
    basket: Basket
    added_s: float
    numbers: int


def purchases(scenes: Sequence[SceneResult], left_s: float, fixed: Collection[str] = ()) -> dict[str, Purchase]:
    """What to buy for each scene in doubt with ``left_s`` CPU seconds for all of them, the cheapest decisions first.

    ``fixed`` are the scenes whose samples may not be raised.
    """
    known = {scene.name: scene for scene in scenes}
    open_levels = {name: levels(scene) for name, scene in known.items()}
    bought: dict[str, dict[str, int]] = {name: {} for name in known}
    baskets: dict[str, Basket] = {}
    while True:
        steps = [
            step
            for name, views in open_levels.items()
            for view in views
            if (step := _next(known[name], view, views, bought[name], baskets.get(name), name in fixed)) is not None
        ]
        steps = [step for step in steps if step.added_s <= left_s]
        if not steps:
            break
        best = min(steps, key=lambda step: (step.added_s / step.numbers, step.scene, step.view))
        left_s -= best.added_s
        baskets[best.scene] = best.basket
        bought[best.scene][best.view] = bought[best.scene].get(best.view, 0) + best.numbers
    return {name: _purchase(known[name], basket, sum(bought[name].values())) for name, basket in baskets.items()}


def _next(
    scene: SceneResult,
    view: str,
    open_levels: Mapping[str, Sequence[float]],
    bought: Mapping[str, int],
    basket: Basket | None,
    is_fixed: bool,
) -> _Step | None:
    """The next open number of a view, and all others that the same work decides; None where there is none."""
    done = bought.get(view, 0)
    if done >= len(open_levels[view]):
        return None
    wanted = {name: open_levels[name][count - 1] for name, count in bought.items()}
    wanted[view] = open_levels[view][done]
    found = cheapest(scene, wanted, fixed_samples=is_fixed)
    if found is None:
        return None
    numbers = sum(level <= wanted[view] for level in open_levels[view]) - done
    added_s = found.price_s - (basket.price_s if basket else 0.0)
    return _Step(scene.name, view, found, max(added_s, 0.0), numbers)


def _purchase(scene: SceneResult, basket: Basket, numbers: int) -> Purchase:
    return Purchase(
        samples={name: math.ceil(samples_of(scene, name) * times) for name, times in basket.samples.items()},
        photons=math.ceil(number_in(scene.settings, "photons", 0.0) * basket.photons),
        numbers=numbers,
        predicted_s=basket.price_s,
    )


def offer(scene: SceneResult, left_s: float, budget_s: float, *, fixed_samples: bool = False) -> MoreSamples | None:
    """What deciding the open numbers of a scene costs, and whether the ``left_s`` of ``budget_s`` pay for it.

    Numbers that ask for more than a machine holds are counted and not priced.
    """
    if scene.verdict is not Verdict.INCONCLUSIVE:
        return None
    open_levels = levels(scene)
    wanted = _within_reach(scene, open_levels, fixed_samples=fixed_samples)
    basket = cheapest(scene, wanted, fixed_samples=fixed_samples) if wanted else None
    if basket is None:
        is_open = any(can_decide(entry) for each in scene.observations for entry in each.comparisons)
        dear = "more than a machine holds is needed to decide what is in doubt; --quality reference starts with more"
        reason = dear if is_open else "more samples cannot decide what is in doubt"
        return MoreSamples(budget_s=budget_s, affordable=False, reason=reason)
    decided = sum(level <= wanted[view] for view in wanted for level in open_levels[view])
    numbers = f"{decided} of {sum(map(len, open_levels.values()))} open numbers"
    left = f"{_short(left_s)} of the {_short(budget_s)} CPU s of this run are left"
    return MoreSamples(
        factor=max(basket.photons, *basket.samples.values()),
        cpu_s=basket.price_s,
        budget_s=budget_s,
        affordable=basket.price_s <= left_s,
        reason=f"to decide {numbers} takes {_in_words(basket)}, about {_short(basket.price_s)} CPU s more; {left}",
    )


def _in_words(basket: Basket) -> str:
    samples = ", ".join(f"{_short(times)} in {view or 'the picture'}" for view, times in basket.samples.items())
    return f"{_short(basket.photons)} times the photons and {samples} times the samples"


def _within_reach(
    scene: SceneResult, open_levels: Mapping[str, Sequence[float]], *, fixed_samples: bool
) -> dict[str, float]:
    """By view, the largest factor that anything buys; a view without any is left out."""
    found = {}
    for view, factors in open_levels.items():
        bought = [level for level in factors if cheapest(scene, {view: level}, fixed_samples=fixed_samples)]
        if bought:
            found[view] = bought[-1]
    return found


def _short(value: float) -> str:
    """Two digits where there are no more before the point."""
    return f"{value:.0f}" if value >= 10 else f"{value:.2g}"
