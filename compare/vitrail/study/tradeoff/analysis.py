"""From stored rows to fronts, knees, orders and prices; needs no renderer."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from vitrail.pipeline.task import Row
from vitrail.study.statistics import (
    Interval,
    Setting,
    cost_of_error,
    error_at_cost,
    knee,
    pareto_front,
)
from vitrail.study.tradeoff.knobs import Knobs
from vitrail.study.tradeoff.orders import orders_of
from vitrail.study.tradeoff.sentence import sentence

TARGETS = (0.05, 0.01, 0.001)
BUDGETS_S = (0.1, 0.3, 1.0, 3.0, 10.0)
DRAWS = 400
"""Parametric bootstrap: 400 draws place the 95 % limits to about a tenth of their distance."""


def analyse_rows(rows: Sequence[Row]) -> dict[str, Any]:
    """One entry a phenomenon, with both engines in it; failed rows are listed with their words."""
    settings = [row for row in rows if row.kind == "setting"]
    own = {row.key: row for row in rows if row.kind == "reference" and row.result is not None}
    phenomena: dict[str, dict[str, Any]] = {}
    for phenomenon in _phenomena(settings):
        own_error = _own_error(own.values(), phenomenon)
        engines = {}
        for engine in ("tracer", "povray"):
            tried = _settings(settings, phenomenon, engine)
            if tried:
                engines[engine] = _engine_record(tried, own_error)
        phenomena[phenomenon] = {
            "engines": engines,
            "equal_error": [_equal_error(engines, target) for target in TARGETS],
            "equal_time": [_equal_time(engines, budget) for budget in BUDGETS_S],
            "reference": "closed form" if own_error is None else "converged rendering",
            "reference_error": own_error,
            "sentence": sentence(phenomenon, engines, TARGETS, own_error),
        }
    return {
        "vitrail_tradeoff": 2,
        "phenomena": phenomena,
        "failures": [{"spec": dict(row.spec), "failure": row.failure} for row in rows if row.failure],
    }


def _phenomena(rows: Iterable[Row]) -> list[str]:
    found = [error["phenomenon"] for row in rows for error in (row.result or {}).get("errors", ())]
    return list(dict.fromkeys(found))


def _own_error(references: Iterable[Row], phenomenon: str) -> float | None:
    """Root mean square over the metrics of what two converged renderings differ; None where a formula is the truth."""
    errors = [
        error["error"]
        for row in references
        for error in (row.result or {})["errors"]
        if error["phenomenon"] == phenomenon
    ]
    return math.sqrt(math.fsum(error**2 for error in errors) / len(errors)) if errors else None


def _settings(rows: Sequence[Row], phenomenon: str, engine: str) -> list[tuple[Mapping[str, Any], dict[str, Any]]]:
    """Knobs and what came of them; rows that differ in their seed only are one setting."""
    groups: dict[str, list[Row]] = defaultdict(list)
    for row in rows:
        if row.result is not None and row.spec["engine"] == engine:
            groups[_label(row)].append(row)
    return [
        ({**group[0].spec["settings"], **group[0].spec["wishes"]}, found)
        for label, group in groups.items()
        if (found := _setting(label, group, phenomenon)) is not None
    ]


def _label(row: Row) -> str:
    return Knobs(row.spec["engine"], row.spec["settings"], row.spec["wishes"], row.spec["seed"]).label


def _setting(label: str, rows: Sequence[Row], phenomenon: str) -> dict[str, Any] | None:
    """Root mean square error over metrics and seeds; bias and spread are those of the mean over the metrics.

    The cost is the least of the runs, with their range: other work on the machine only ever adds to CPU seconds. Runs
    that give the same errors to the bit are one sample of the error and several of the cost.
    """
    entries = [[error for error in (row.result or {})["errors"] if error["phenomenon"] == phenomenon] for row in rows]
    entries = [entry for entry in entries if [e["metric"] for e in entry] == [e["metric"] for e in entries[0]]]
    if not all(entries):
        return None
    pairs = np.array([[[error["error"], error["standard_error"]] for error in entry] for entry in entries])
    errors, doubts = np.moveaxis(np.unique(pairs, axis=0), -1, 0)
    rms = float(np.sqrt((errors**2).mean()))
    # The noise of a seed's errors is known from its half images; draw it again to see how the rms scatters.
    rng = np.random.default_rng(0)
    draws = np.sqrt(((errors + doubts * rng.standard_normal((DRAWS, *errors.shape))) ** 2).mean(axis=(1, 2)))
    scatter = float(np.std(draws))
    costs = [row.cost["cpu_s"] for row in rows]
    spread = float(errors.std(axis=0, ddof=1).mean()) if len(errors) > 1 else float(doubts.mean())
    return {
        "setting": Setting(
            label,
            Interval(min(costs), min(costs), max(costs), 1.0),
            Interval(rms, max(rms - 1.96 * scatter, 0.0), rms + 1.96 * scatter),
            float(np.sqrt((errors.mean(axis=0) ** 2).mean())),
            spread,
        ),
        "peak_memory_bytes": max(row.cost.get("peak_memory_bytes", 0.0) for row in rows) or None,
        "runs": len(rows),
    }


def _engine_record(tried: Sequence[tuple[Mapping[str, Any], dict[str, Any]]], own_error: float | None) -> dict:
    settings: list[Setting] = [found["setting"] for _, found in tried]
    front = pareto_front(settings)
    bend = knee(front)
    return {
        "settings": [
            _record(found["setting"], found["setting"] in front, found["setting"] is bend)
            | {"knobs": dict(knobs), "peak_memory_bytes": found["peak_memory_bytes"], "runs": found["runs"]}
            for knobs, found in tried
        ],
        "orders": orders_of([(knobs, found["setting"]) for knobs, found in tried]),
        "price_s": {str(target): _price(front, target, own_error) for target in TARGETS},
        "error_at_s": {str(budget): error_at_cost(front, budget) for budget in BUDGETS_S},
        "best_error": min(s.error.value for s in settings),
    }


def _price(front: Sequence[Setting], target: float, own_error: float | None) -> dict[str, Any]:
    """CPU seconds, and whether they are a price, an upper limit, or cannot be told."""
    if own_error is not None and target < own_error:
        return {"status": "below_reference", "cpu_s": None}
    cost = cost_of_error(front, target)
    if cost is None:
        return {"status": "not_reached", "cpu_s": None}
    return {"status": "at_most" if front[0].error.value <= target else "reached", "cpu_s": cost}


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
    seconds = [prices.get(engine, {}).get("cpu_s") for engine in ("povray", "tracer")]
    return {"target": target, **prices, "povray_over_tracer": _ratio(*seconds)}


def _equal_time(engines: dict[str, Any], budget: float) -> dict[str, Any]:
    errors = {engine: record["error_at_s"][str(budget)] for engine, record in engines.items()}
    return {"budget_s": budget, **errors, "povray_over_tracer": _ratio(errors.get("povray"), errors.get("tracer"))}


def _ratio(above: float | None, below: float | None) -> float | None:
    return above / below if above and below else None
