"""Settings for a budget or for an error, chosen by the model of a finished study; then run, to score the prediction."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from vitrail.base.engine_name import EngineName
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.progress import Progress, silent
from vitrail.base.record import write_record
from vitrail.engines.engine_build import engine_build
from vitrail.pipeline.campaign import Campaign, run_campaign
from vitrail.pipeline.task import Row, Task
from vitrail.plan.settings import setting_names
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash
from vitrail.study.tradeoff.knobs import ENGINES, label_of
from vitrail.study.tradeoff.measure import Measure
from vitrail.study.tradeoff.model import Prediction, best_for_budget, best_for_error, series_of
from vitrail.study.tradeoff.predictions import CostAndError, Predictions, ScoredPrediction
from vitrail.study.tradeoff.records import Errors, RunCost, Tradeoff
from vitrail.study.tradeoff.sentence import NAMES

FRESH_SEEDS = (9001, 9002, 9003)
"""Seeds that no setting of the study used: a prediction is scored on runs it has not seen."""


@dataclass(frozen=True)
class Aim:
    """What is wanted of one phenomenon: an error, or what a budget buys. One of the two is given."""

    phenomenon: Phenomenon
    error: float | None = None
    budget_s: float | None = None


def predict(
    loaded: Loaded,
    out: Path,
    found: Tradeoff,
    measure: Measure,
    aims: Sequence[Aim],
    progress: Progress = silent,
) -> Predictions:
    """Choose settings in both engines for every aim, run them, and write predictions.json into ``out``."""
    chosen = [(aim, engine, _choose(found, aim, engine)) for aim in aims for engine in ENGINES]
    tasks = {
        (aim, engine): _tasks(loaded, engine, prediction)
        for aim, engine, prediction in chosen
        if prediction is not None
    }
    everything = [task for group in tasks.values() for task in group]
    campaign = Campaign(everything, {"setting": measure.setting})
    rows = run_campaign(campaign, out / "predictions", progress=progress)
    by_key = {row.key: row for row in rows}
    scored = Predictions(
        tuple(
            _scored(aim, engine, prediction, [by_key[task.key] for task in tasks.get((aim, engine), ())])
            for aim, engine, prediction in chosen
        )
    )
    write_record(scored, out / "predictions.json")
    return scored


def _choose(found: Tradeoff, aim: Aim, engine: EngineName) -> Prediction | None:
    front = found.phenomena[aim.phenomenon].engines.get(engine)
    if front is None:
        return None
    laws = series_of(front.settings)
    return best_for_error(laws, aim.error) if aim.error is not None else best_for_budget(laws, aim.budget_s or 0.0)


def _tasks(loaded: Loaded, engine: EngineName, prediction: Prediction) -> list[Task]:
    """One run a fresh seed."""
    settings = {name: value for name, value in prediction.knobs.items() if name in setting_names()}
    wishes = {name: value for name, value in prediction.knobs.items() if name not in setting_names()}
    spec = {"scene": scene_hash(loaded.scene), "engine": engine, "build": engine_build(engine)}
    return [Task("setting", {**spec, "settings": settings, "wishes": wishes, "seed": seed}) for seed in FRESH_SEEDS]


def _scored(aim: Aim, engine: EngineName, prediction: Prediction | None, rows: Sequence[Row]) -> ScoredPrediction:
    """The aim, the prediction, and what the fresh runs came to."""
    if prediction is None:
        return ScoredPrediction(phenomenon=aim.phenomenon, target_error=aim.error, budget_s=aim.budget_s, engine=engine)
    return ScoredPrediction(
        phenomenon=aim.phenomenon,
        target_error=aim.error,
        budget_s=aim.budget_s,
        engine=engine,
        knobs=dict(prediction.knobs),
        label=label_of(prediction.knobs),
        predicted=CostAndError(cost_s=prediction.cost_s, error=prediction.error),
        measured=_measured(aim.phenomenon, [row for row in rows if row.result is not None]),
    )


def _measured(phenomenon: Phenomenon, rows: Sequence[Row]) -> CostAndError | None:
    """The root mean square error of the runs and the least of their costs; None if none measured the phenomenon."""
    errors = [entry.error for row in rows for entry in Errors.model_validate(row.result).of(phenomenon)]
    if not errors:
        return None
    rms = math.sqrt(math.fsum(error**2 for error in errors) / len(errors))
    return CostAndError(cost_s=min(RunCost.model_validate(row.cost).cpu_s for row in rows), error=rms)


def prediction_line(scored: ScoredPrediction) -> str:
    """One prediction with its score, in words."""
    wish = f"{100 * scored.target_error:g} % error" if scored.target_error is not None else f"{scored.budget_s:g} CPU s"
    start = f"{scored.phenomenon.replace('_', ' ')}, {wish}, {NAMES[scored.engine]}: {scored.label}"
    said, was = scored.predicted, scored.measured
    if said is None or was is None:
        return start
    return (
        f"{start}: predicted {100 * said.error:.2g} % in {said.cost_s:.2g} CPU s,"
        f" measured {100 * was.error:.2g} % in {was.cost_s:.2g} CPU s"
    )
