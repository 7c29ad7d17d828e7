"""Orders of convergence: how error, spread and cost follow the number of photons or samples, all else held."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from vitrail.base.canonical_json import json_line
from vitrail.study.statistics import Estimate, convergence_order
from vitrail.study.tradeoff.knobs import label_of
from vitrail.study.tradeoff.records import Order, TriedSetting

WORK = ("photons", "samples")
"""The knobs that buy accuracy by more of the same work: noise falls with their root, bias does not fall."""


def orders_of(tried: Sequence[TriedSetting]) -> list[Order]:
    """One entry for each series of at least three settings that differ in one work knob alone.

    ``error`` and ``spread`` are slopes of their logarithm against that of the knob, with 95 % intervals: -1/2 for
    noise of independent samples, 0 where bias is all that is left.
    """
    return [
        Order(
            along=knob,
            held=held,
            settings=len(series),
            error=_slope(series, [setting.error.value for _, setting in series]),
            spread=_slope(series, [setting.standard_deviation for _, setting in series]),
            cost=_slope(series, [setting.cost_s.value for _, setting in series]),
        )
        for knob in WORK
        for held, series in _series(tried, knob).items()
    ]


Along = list[tuple[float, TriedSetting]]
"""Settings with the amount of work in which they differ."""


def _series(tried: Sequence[TriedSetting], knob: str) -> dict[str, Along]:
    """Settings in the order of ``knob``, by the label of all other knobs; series of fewer than three are left out."""
    groups: dict[str, Along] = defaultdict(list)
    labels: dict[str, str] = {}
    for setting in tried:
        if knob in setting.knobs:
            rest = {name: value for name, value in setting.knobs.items() if name != knob}
            labels[json_line(rest)] = label_of(rest)
            groups[json_line(rest)].append((setting.amount(knob), setting))
    return {labels[key]: sorted(series, key=lambda each: each[0]) for key, series in groups.items() if len(series) >= 3}


def _slope(series: Along, values: Sequence[float]) -> Estimate | None:
    """The slope with its interval; None where a value is 0 and has no logarithm."""
    if min(values) <= 0:
        return None
    return convergence_order([work for work, _ in series], values)
