"""Statistics of error against cost: intervals, convergence order, Pareto front, knee, equal-time and equal-error.

Errors are relative and positive; costs are CPU seconds. Everything here is a pure function of the stored samples.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from scipy import stats

from vitrail.base.record import Record


class Estimate(Record):
    """A value with its two-sided confidence interval at ``level``; at level 1 the range of all values seen."""

    value: float
    low: float
    high: float
    level: float = 0.95


class Setting(Record):
    """One setting of one engine: its root-mean-square error and its cost, both over repeated seeds."""

    label: str
    cost_s: Estimate
    error: Estimate
    bias: float
    standard_deviation: float


S = TypeVar("S", bound=Setting)


def pareto_front(settings: Sequence[S]) -> list[S]:
    """Settings that no other beats in both cost and error, from cheap to expensive."""
    front: list[S] = []
    for candidate in sorted(settings, key=lambda s: (s.cost_s.value, s.error.value)):
        if not front or candidate.error.value < front[-1].error.value:
            front.append(candidate)
    return front


def knee(front: Sequence[S]) -> S | None:
    """The setting after which accuracy gets dearer: farthest below the chord of the front in log-log axes.

    None where the front has fewer than three settings or is nowhere below its chord.
    """
    if len(front) < 3:
        return None
    x = np.log([s.cost_s.value for s in front])
    y = np.log([max(s.error.value, 1e-300) for s in front])
    chord = y[0] + (y[-1] - y[0]) * (x - x[0]) / (x[-1] - x[0])
    below = chord - y
    best = int(np.argmax(below))
    return front[best] if below[best] > 1e-9 else None


def convergence_order(costs_s: Sequence[float], errors: Sequence[float], level: float = 0.95) -> Estimate:
    """Slope of log error against log cost by least squares: -1/2 for an unbiased estimator, flatter under bias."""
    x, y = np.log(np.asarray(costs_s, dtype=float)), np.log(np.asarray(errors, dtype=float))
    if len(x) < 3:
        raise ValueError(f"a slope with an interval needs three settings, got {len(x)}")
    fit = stats.linregress(x, y)
    half = float(stats.t.ppf(0.5 + level / 2, len(x) - 2) * fit.stderr)
    slope = float(fit.slope)
    return Estimate(value=slope, low=slope - half, high=slope + half, level=level)


def cost_of_error(front: Sequence[Setting], target: float) -> float | None:
    """CPU seconds at which the front first has ``target`` error (log-log interpolation); None if it never does."""
    previous: Setting | None = None
    for setting in front:
        if setting.error.value <= target:
            if previous is None:
                return setting.cost_s.value
            return _interpolate(
                previous.error.value, previous.cost_s.value, setting.error.value, setting.cost_s.value, target
            )
        previous = setting
    return None


def error_at_cost(front: Sequence[Setting], budget_s: float) -> float | None:
    """Smallest error that a measured setting reaches within ``budget_s``; None if none is that cheap."""
    affordable = [s.error.value for s in front if s.cost_s.value <= budget_s]
    return min(affordable) if affordable else None


def _interpolate(x0: float, y0: float, x1: float, y1: float, x: float) -> float:
    if x1 <= 0 or x0 <= 0 or x0 == x1:
        return y1
    share = (math.log(x) - math.log(x0)) / (math.log(x1) - math.log(x0))
    return math.exp(math.log(y0) + share * (math.log(y1) - math.log(y0)))
