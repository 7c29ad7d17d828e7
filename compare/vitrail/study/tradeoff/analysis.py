"""From stored rows to fronts, knees, orders and prices; needs no renderer."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from vitrail.base.engine_name import EngineName
from vitrail.base.phenomenon import Phenomenon
from vitrail.pipeline.task import Row
from vitrail.study.statistics import Estimate, Setting, cost_of_error, error_at_cost, knee, pareto_front
from vitrail.study.tradeoff.knobs import ENGINES, Knobs, KnobValue
from vitrail.study.tradeoff.orders import orders_of
from vitrail.study.tradeoff.records import (
    EngineFront,
    EqualError,
    EqualTime,
    Errors,
    FailedTask,
    PhenomenonPrices,
    Price,
    RunCost,
    Tradeoff,
    TriedSetting,
)
from vitrail.study.tradeoff.sentence import sentence

TARGETS = (0.05, 0.01, 0.001)
BUDGETS_S = (0.1, 0.3, 1.0, 3.0, 10.0)
DRAWS = 400
"""Parametric bootstrap: 400 draws place the 95 % limits to about a tenth of their distance."""


@dataclass(frozen=True)
class Sample:
    """A row that has errors, with its result and its cost as types."""

    row: Row
    errors: Errors
    cost: RunCost

    @property
    def knobs(self) -> Knobs:
        spec = self.row.spec
        return Knobs(spec["engine"], spec["settings"], spec["wishes"], spec["seed"])


def analyse_rows(rows: Sequence[Row], scene: str, title: str) -> Tradeoff:
    """One entry a phenomenon, with both engines in it; failed rows are listed with their words."""
    samples = [
        Sample(row, Errors.model_validate(row.result), RunCost.model_validate(row.cost))
        for row in rows
        if row.kind == "setting" and row.result is not None
    ]
    references = {row.key: Errors.model_validate(row.result) for row in rows if row.kind == "reference" and row.result}
    found = dict.fromkeys(error.phenomenon for sample in samples for error in sample.errors.errors)
    return Tradeoff(
        scene=scene,
        title=title,
        phenomena={phenomenon: _prices(samples, references.values(), phenomenon) for phenomenon in found},
        failures=tuple(FailedTask(spec=dict(row.spec), failure=row.failure) for row in rows if row.failure),
    )


def _prices(samples: Sequence[Sample], references: Iterable[Errors], phenomenon: Phenomenon) -> PhenomenonPrices:
    """What one phenomenon costs in both engines."""
    own_error = _own_error(references, phenomenon)
    engines: dict[EngineName, EngineFront] = {}
    for engine in ENGINES:
        tried = _settings(samples, phenomenon, engine)
        if tried:
            engines[engine] = _engine_front(tried, own_error)
    return PhenomenonPrices(
        engines=engines,
        equal_error=tuple(_equal_error(engines, target) for target in TARGETS),
        equal_time=tuple(_equal_time(engines, budget) for budget in BUDGETS_S),
        reference="closed form" if own_error is None else "converged rendering",
        reference_error=own_error,
        sentence=sentence(phenomenon, {name: front.price_s for name, front in engines.items()}, TARGETS, own_error),
    )


def _own_error(references: Iterable[Errors], phenomenon: Phenomenon) -> float | None:
    """Root mean square over the metrics of what two converged renderings differ; None where a formula is the truth."""
    errors = [entry.error for reference in references for entry in reference.of(phenomenon)]
    return math.sqrt(math.fsum(error**2 for error in errors) / len(errors)) if errors else None


@dataclass(frozen=True)
class Tried:
    """One setting with its knobs, before it is known what beats it."""

    setting: Setting
    knobs: dict[str, KnobValue]
    peak_memory_bytes: float | None
    runs: int


def _settings(samples: Sequence[Sample], phenomenon: Phenomenon, engine: EngineName) -> list[Tried]:
    """What came of every setting; samples that differ in their seed only are one setting."""
    groups: dict[str, list[Sample]] = defaultdict(list)
    for sample in samples:
        if sample.knobs.engine == engine:
            groups[sample.knobs.label].append(sample)
    found = [_setting(label, group, phenomenon) for label, group in groups.items()]
    return [tried for tried in found if tried is not None]


def _setting(label: str, samples: Sequence[Sample], phenomenon: Phenomenon) -> Tried | None:
    """Root mean square error over metrics and seeds; bias and spread are those of the mean over the metrics.

    The cost is the least of the runs, with their range: other work on the machine only ever adds to CPU seconds. Runs
    that give the same errors to the bit are one sample of the error and several of the cost.
    """
    entries = [sample.errors.of(phenomenon) for sample in samples]
    entries = [entry for entry in entries if [e.metric for e in entry] == [e.metric for e in entries[0]]]
    if not all(entries):
        return None
    pairs = np.array([[[each.error, each.standard_error] for each in entry] for entry in entries])
    errors, doubts = np.moveaxis(np.unique(pairs, axis=0), -1, 0)
    rms = float(np.sqrt((errors**2).mean()))
    # The noise of a seed's errors is known from its half images; draw it again to see how the rms scatters.
    rng = np.random.default_rng(0)
    draws = np.sqrt(((errors + doubts * rng.standard_normal((DRAWS, *errors.shape))) ** 2).mean(axis=(1, 2)))
    scatter = float(np.std(draws))
    costs = [sample.cost.cpu_s for sample in samples]
    spread = float(errors.std(axis=0, ddof=1).mean()) if len(errors) > 1 else float(doubts.mean())
    setting = Setting(
        label=label,
        cost_s=Estimate(value=min(costs), low=min(costs), high=max(costs), level=1.0),
        error=Estimate(value=rms, low=max(rms - 1.96 * scatter, 0.0), high=rms + 1.96 * scatter),
        bias=float(np.sqrt((errors.mean(axis=0) ** 2).mean())),
        standard_deviation=spread,
    )
    first = samples[0].knobs
    peak_bytes = max(sample.cost.peak_memory_bytes for sample in samples)
    return Tried(setting, {**first.settings, **first.wishes}, peak_bytes or None, len(samples))


def _engine_front(tried: Sequence[Tried], own_error: float | None) -> EngineFront:
    """The settings of one engine with their front, and what an error or a budget comes to on it."""
    front = pareto_front([each.setting for each in tried])
    bend = knee(front)
    settings = tuple(
        TriedSetting(
            **dict(each.setting),
            on_front=each.setting in front,
            at_knee=each.setting is bend,
            knobs=each.knobs,
            peak_memory_bytes=each.peak_memory_bytes,
            runs=each.runs,
        )
        for each in tried
    )
    return EngineFront(
        settings=settings,
        orders=tuple(orders_of(settings)),
        price_s={str(target): _price(front, target, own_error) for target in TARGETS},
        error_at_s={str(budget): error_at_cost(front, budget) for budget in BUDGETS_S},
        best_error=min(each.setting.error.value for each in tried),
    )


def _price(front: Sequence[Setting], target: float, own_error: float | None) -> Price:
    """CPU seconds, and whether they are a price, an upper limit, or cannot be told."""
    if own_error is not None and target < own_error:
        return Price(status="below_reference", cpu_s=None)
    cost = cost_of_error(front, target)
    if cost is None:
        return Price(status="not_reached", cpu_s=None)
    return Price(status="at_most" if front[0].error.value <= target else "reached", cpu_s=cost)


def _equal_error(engines: Mapping[EngineName, EngineFront], target: float) -> EqualError:
    prices = {engine: front.price_s[str(target)] for engine, front in engines.items()}
    tracer, povray = prices.get(EngineName.TRACER), prices.get(EngineName.POVRAY)
    ratio = _ratio(povray.cpu_s, tracer.cpu_s) if povray and tracer else None
    return EqualError(target=target, tracer=tracer, povray=povray, povray_over_tracer=ratio)


def _equal_time(engines: Mapping[EngineName, EngineFront], budget_s: float) -> EqualTime:
    errors = {engine: front.error_at_s[str(budget_s)] for engine, front in engines.items()}
    tracer, povray = errors.get(EngineName.TRACER), errors.get(EngineName.POVRAY)
    ratio = _ratio(povray, tracer)
    return EqualTime(budget_s=budget_s, tracer=tracer, povray=povray, povray_over_tracer=ratio)


def _ratio(above: float | None, below: float | None) -> float | None:
    return above / below if above and below else None
