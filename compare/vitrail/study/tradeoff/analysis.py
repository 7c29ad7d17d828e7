"""From stored rows to fronts, knees, orders and prices; needs no renderer."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from vitrail.study.statistics import (
    Interval,
    Setting,
    convergence_order,
    cost_of_error,
    error_at_cost,
    knee,
    mean_interval,
    pareto_front,
)
from vitrail.study.task import Row
from vitrail.study.tradeoff.knobs import Knobs

TARGETS = (0.05, 0.01, 0.001)
BUDGETS_S = (0.1, 0.3, 1.0, 3.0, 10.0)
DRAWS = 400
"""Parametric bootstrap: 400 draws place the 95 % limits to about a tenth of their distance."""


def analyse_rows(rows: Sequence[Row]) -> dict[str, Any]:
    """One entry a phenomenon, with both engines in it; failed rows are listed with their words."""
    phenomena: dict[str, dict[str, Any]] = {}
    for phenomenon in _phenomena(rows):
        engines = {}
        for engine in ("tracer", "povray"):
            settings = _settings(rows, phenomenon, engine)
            if settings:
                engines[engine] = _engine_record(settings)
        phenomena[phenomenon] = {
            "engines": engines,
            "equal_error": [_equal_error(engines, target) for target in TARGETS],
            "equal_time": [_equal_time(engines, budget) for budget in BUDGETS_S],
            "sentence": sentence(phenomenon, engines),
        }
    return {
        "vitrail_tradeoff": 1,
        "phenomena": phenomena,
        "failures": [{"spec": dict(row.spec), "failure": row.failure} for row in rows if row.failure],
    }


def sentence(phenomenon: str, engines: dict[str, Any]) -> str:
    """What 5 %, 1 % and 0.1 % cost in each engine, in plain words."""
    parts = []
    for engine, name in (("tracer", "the tracer"), ("povray", "POV-Ray")):
        if engine in engines:
            prices = [_price(engines[engine]["price_s"][str(target)]) for target in TARGETS]
            parts.append(f"{name} {prices[0]}, {prices[1]} and {prices[2]}")
    return f"An error of 5 %, 1 % and 0.1 % in the {phenomenon.replace('_', ' ')} costs " + "; ".join(parts) + "."


def _price(seconds: float | None) -> str:
    if seconds is None:
        return "not reached"
    return f"{seconds:.2g} CPU s" if seconds < 10 else f"{seconds:.0f} CPU s"


def _phenomena(rows: Iterable[Row]) -> list[str]:
    found = [error["phenomenon"] for row in rows for error in (row.result or {}).get("errors", ())]
    return list(dict.fromkeys(found))


def _settings(rows: Sequence[Row], phenomenon: str, engine: str) -> list[Setting]:
    """Rows that differ in their seed only are one setting."""
    groups: dict[str, list[Row]] = defaultdict(list)
    for row in rows:
        if row.result is not None and row.spec["engine"] == engine:
            groups[_label(row)].append(row)
    return [found for label, group in groups.items() if (found := _setting(label, group, phenomenon)) is not None]


def _label(row: Row) -> str:
    return Knobs(row.spec["engine"], row.spec["settings"], row.spec["transport"], row.spec["seed"]).label


def _setting(label: str, rows: Sequence[Row], phenomenon: str) -> Setting | None:
    """Root mean square error over metrics and seeds; bias and spread are those of the mean over the metrics."""
    entries = [[error for error in (row.result or {})["errors"] if error["phenomenon"] == phenomenon] for row in rows]
    if not all(entries):
        return None
    errors = np.array([[error["error"] for error in entry] for entry in entries])
    doubts = np.array([[error["standard_error"] for error in entry] for entry in entries])
    rms = float(np.sqrt((errors**2).mean()))
    # The noise of a seed's errors is known from its half images; draw it again to see how the rms scatters.
    rng = np.random.default_rng(0)
    draws = np.sqrt(((errors + doubts * rng.standard_normal((DRAWS, *errors.shape))) ** 2).mean(axis=(1, 2)))
    scatter = float(np.std(draws))
    interval = Interval(rms, max(rms - 1.96 * scatter, 0.0), rms + 1.96 * scatter)
    spread = float(errors.std(axis=0, ddof=1).mean()) if len(rows) > 1 else float(doubts.mean())
    costs = [row.cost["cpu_s"] for row in rows]
    cost = mean_interval(costs) if len(costs) > 1 else Interval(costs[0], costs[0], costs[0])
    bias = float(np.sqrt((errors.mean(axis=0) ** 2).mean()))
    return Setting(label, cost, interval, bias, spread)


def _engine_record(settings: Sequence[Setting]) -> dict[str, Any]:
    front = pareto_front(settings)
    bend = knee(front)
    useful = [s for s in front if s.error.value > 0]
    order = (
        convergence_order([s.cost_s.value for s in useful], [s.error.value for s in useful])
        if len(useful) >= 3
        else None
    )
    return {
        "settings": [_record(s, s in front, s is bend) for s in settings],
        "order": _finite(asdict(order)) if order else None,
        "price_s": {str(target): cost_of_error(front, target) for target in TARGETS},
        "error_at_s": {str(budget): error_at_cost(front, budget) for budget in BUDGETS_S},
        "best_error": min(s.error.value for s in settings),
    }


def _record(setting: Setting, on_front: bool, at_knee: bool) -> dict[str, Any]:
    return {
        "label": setting.label,
        "cost_s": _finite(asdict(setting.cost_s)),
        "error": _finite(asdict(setting.error)),
        "bias": setting.bias,
        "standard_deviation": setting.standard_deviation,
        "on_front": on_front,
        "at_knee": at_knee,
    }


def _finite(record: dict[str, Any]) -> dict[str, Any]:
    """Unbounded ends of an interval as null: JSON has no infinity."""
    return {key: None if isinstance(v, float) and not math.isfinite(v) else v for key, v in record.items()}


def _equal_error(engines: dict[str, Any], target: float) -> dict[str, Any]:
    prices = {engine: record["price_s"][str(target)] for engine, record in engines.items()}
    ratio = _ratio(prices.get("povray"), prices.get("tracer"))
    return {"target": target, **prices, "povray_over_tracer": ratio}


def _equal_time(engines: dict[str, Any], budget: float) -> dict[str, Any]:
    errors = {engine: record["error_at_s"][str(budget)] for engine, record in engines.items()}
    return {"budget_s": budget, **errors, "povray_over_tracer": _ratio(errors.get("povray"), errors.get("tracer"))}


def _ratio(above: float | None, below: float | None) -> float | None:
    return above / below if above and below else None
