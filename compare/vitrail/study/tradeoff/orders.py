"""Orders of convergence: how error, spread and cost follow the number of photons or samples, all else held."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from vitrail.pipeline.task import canonical
from vitrail.study.statistics import Interval, Setting, convergence_order
from vitrail.study.tradeoff.knobs import label_of

WORK = ("photons", "samples")
"""The knobs that buy accuracy by more of the same work: noise falls with their root, bias does not fall."""


def orders_of(tried: Sequence[tuple[Mapping[str, Any], Setting]]) -> list[dict[str, Any]]:
    """One entry for each series of at least three settings that differ in one work knob alone.

    ``error`` and ``spread`` are slopes of their logarithm against that of the knob, with 95 % intervals: -1/2 for
    noise of independent samples, 0 where bias is all that is left.
    """
    found = []
    for knob in WORK:
        for held, series in _series(tried, knob).items():
            found.append(
                {
                    "along": knob,
                    "held": held,
                    "settings": len(series),
                    "error": _slope(series, [setting.error.value for _, setting in series]),
                    "spread": _slope(series, [setting.standard_deviation for _, setting in series]),
                    "cost": _slope(series, [setting.cost_s.value for _, setting in series]),
                }
            )
    return found


def _series(tried: Sequence[tuple[Mapping[str, Any], Setting]], knob: str) -> dict[str, list[tuple[float, Setting]]]:
    """Settings in the order of ``knob``, by the label of all other knobs; series of fewer than three are left out."""
    groups: dict[str, list[tuple[float, Setting]]] = defaultdict(list)
    labels: dict[str, str] = {}
    for knobs, setting in tried:
        if knob in knobs:
            rest = {name: value for name, value in knobs.items() if name != knob}
            labels[canonical(rest)] = label_of(rest)
            groups[canonical(rest)].append((float(knobs[knob]), setting))
    return {labels[key]: sorted(series, key=lambda each: each[0]) for key, series in groups.items() if len(series) >= 3}


def _slope(series: Sequence[tuple[float, Setting]], values: Sequence[float]) -> dict[str, Any] | None:
    """The slope with its interval; None where a value is 0 and has no logarithm."""
    if min(values) <= 0:
        return None
    slope: Interval = convergence_order([work for work, _ in series], values)
    record = asdict(slope)
    return record if all(math.isfinite(v) for v in record.values()) else None
