"""What a study teaches about settings that were not tried: cost and error as functions of the work, fitted to samples.

In each series of settings that differ in one work knob N alone, CPU seconds are a + b N (start-up and work), and the
square of the error is B^2 + V / N (what more work does not remove, and noise). Both are fitted with relative weights
and no negative part. From them follow the settings for a budget or for an error.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import optimize

from vitrail.base.canonical_json import json_line
from vitrail.study.tradeoff.knobs import KnobValue
from vitrail.study.tradeoff.orders import WORK
from vitrail.study.tradeoff.records import TriedSetting

REACH = 4.0
"""How far beyond the most work tried a model may be asked."""


@dataclass(frozen=True)
class Prediction:
    """Knobs that were chosen, what they should cost and how wrong the image should be."""

    knobs: Mapping[str, KnobValue]
    cost_s: float
    error: float


@dataclass(frozen=True)
class Series:
    """One engine's settings along one work knob, all else held, with the fitted law."""

    knob: str
    held: Mapping[str, KnobValue]
    least: float
    most: float
    start_s: float
    per_unit_s: float
    bias_squared: float
    variance: float

    def at(self, work: float) -> Prediction:
        """What the law says of one amount of work, a whole number."""
        units = max(round(work), 1)
        error = math.sqrt(self.bias_squared + self.variance / units)
        return Prediction({**self.held, self.knob: units}, self.start_s + self.per_unit_s * units, error)

    def for_error(self, target: float) -> Prediction | None:
        """The least work with an error of at most ``target``; None where bias alone is more, or it is out of reach."""
        room = target**2 - self.bias_squared
        if room <= 0:
            return None
        work = max(self.variance / room, self.least)
        return self.at(math.ceil(work)) if work <= REACH * self.most else None

    def for_budget(self, budget_s: float) -> Prediction | None:
        """The most work that ``budget_s`` CPU seconds pay for; None where the least tried costs more."""
        if self.start_s + self.per_unit_s * self.least > budget_s:
            return None
        work = (budget_s - self.start_s) / self.per_unit_s if self.per_unit_s > 0 else math.inf
        return self.at(math.floor(min(work, REACH * self.most)))


def series_of(settings: Sequence[TriedSetting]) -> list[Series]:
    """Laws of all series of at least three settings; ``settings`` as in the analysis of one engine."""
    found = []
    for knob in WORK:
        groups: dict[str, list[TriedSetting]] = {}
        for each in settings:
            if knob in each.knobs:
                held = {name: value for name, value in each.knobs.items() if name != knob}
                groups.setdefault(json_line(held), []).append(each)
        found += [_fitted(knob, group) for group in groups.values() if len(group) >= 3]
    return found


def best_for_error(series: Sequence[Series], target: float) -> Prediction | None:
    """The cheapest settings that should reach ``target``."""
    fitting = [found for each in series if (found := each.for_error(target)) is not None]
    return min(fitting, key=lambda found: found.cost_s, default=None)


def best_for_budget(series: Sequence[Series], budget_s: float) -> Prediction | None:
    """The settings with the least error that should cost no more than ``budget_s``."""
    fitting = [found for each in series if (found := each.for_budget(budget_s)) is not None]
    return min(fitting, key=lambda found: found.error, default=None)


def _fitted(knob: str, group: Sequence[TriedSetting]) -> Series:
    work = np.array([each.amount(knob) for each in group], dtype=float)
    costs = np.array([each.cost_s.value for each in group])
    errors = np.array([each.error.value for each in group])
    start_s, per_unit_s = _law(np.ones_like(work), work, costs)
    bias_squared, variance = _law(np.ones_like(work), 1 / work, np.maximum(errors, 1e-12) ** 2)
    held = {name: value for name, value in group[0].knobs.items() if name != knob}
    return Series(knob, held, work.min(), work.max(), start_s, per_unit_s, bias_squared, variance)


def _law(first: np.ndarray, second: np.ndarray, values: np.ndarray) -> tuple[float, float]:
    """Non-negative p, q for values = p first + q second, least squares of the relative deviation."""
    scale = np.abs(second).max()
    rows = np.stack([first, second / scale], axis=1) / values[:, None]
    (p, q), _ = optimize.nnls(rows, np.ones_like(values))
    return float(p), float(q) / float(scale)
