"""Settings for a budget or for an error, chosen by the model of a finished study; then run, to score the prediction."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vitrail.engines.engine_build import engine_build
from vitrail.pipeline.queue import Progress, run_tasks
from vitrail.pipeline.task import Row, Task
from vitrail.pipeline.task_log import TaskLog
from vitrail.plan.settings import setting_names
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash
from vitrail.study.tradeoff.knobs import ENGINES, EngineName, label_of
from vitrail.study.tradeoff.measure import Measure
from vitrail.study.tradeoff.model import Prediction, best_for_budget, best_for_error, series_of

FRESH_SEEDS = (9001, 9002, 9003)
"""Seeds that no setting of the study used: a prediction is scored on runs it has not seen."""


@dataclass(frozen=True)
class Aim:
    """What is wanted of one phenomenon: an error, or what a budget buys. One of the two is given."""

    phenomenon: str
    error: float | None = None
    budget_s: float | None = None


def predict(
    loaded: Loaded,
    out: Path,
    found: Mapping[str, Any],
    measure: Measure,
    aims: Sequence[Aim],
    report: Callable[[Progress], None] = lambda progress: None,
) -> list[dict[str, Any]]:
    """Choose settings in both engines for every aim, run them, and write predictions.json into ``out``."""
    chosen = [(aim, engine, _choose(found, aim, engine)) for aim in aims for engine in ENGINES]
    tasks = {
        (aim, engine): _tasks(loaded, engine, prediction)
        for aim, engine, prediction in chosen
        if prediction is not None
    }
    everything = [task for group in tasks.values() for task in group]
    rows = run_tasks(everything, TaskLog(out / "predictions"), {"setting": measure.setting}, report=report)
    by_key = {row.key: row for row in rows}
    records = [
        _record(aim, engine, prediction, [by_key[task.key] for task in tasks.get((aim, engine), ())])
        for aim, engine, prediction in chosen
    ]
    (out / "predictions.json").write_text(json.dumps(records, indent=1, sort_keys=True, allow_nan=False) + "\n")
    return records


def _choose(found: Mapping[str, Any], aim: Aim, engine: EngineName) -> Prediction | None:
    record = found["phenomena"][aim.phenomenon]["engines"].get(engine)
    if record is None:
        return None
    laws = series_of(record["settings"])
    return best_for_error(laws, aim.error) if aim.error is not None else best_for_budget(laws, aim.budget_s or 0.0)


def _tasks(loaded: Loaded, engine: EngineName, prediction: Prediction) -> list[Task]:
    """One run a fresh seed."""
    settings = {name: value for name, value in prediction.knobs.items() if name in setting_names()}
    wishes = {name: value for name, value in prediction.knobs.items() if name not in setting_names()}
    spec = {"scene": scene_hash(loaded.scene), "engine": engine, "build": engine_build(engine)}
    return [Task("setting", {**spec, "settings": settings, "wishes": wishes, "seed": seed}) for seed in FRESH_SEEDS]


def _record(aim: Aim, engine: EngineName, prediction: Prediction | None, rows: Sequence[Row]) -> dict[str, Any]:
    """The aim, the prediction, and what the fresh runs came to."""
    record: dict[str, Any] = {
        "phenomenon": aim.phenomenon,
        "target_error": aim.error,
        "budget_s": aim.budget_s,
        "engine": engine,
        "knobs": None,
        "label": "out of reach",
        "predicted": None,
        "measured": None,
    }
    if prediction is None:
        return record
    record |= {"knobs": dict(prediction.knobs), "label": label_of(prediction.knobs)}
    record["predicted"] = {"cost_s": prediction.cost_s, "error": prediction.error}
    good = [(row.result, row.cost) for row in rows if row.result is not None]
    errors = [e["error"] for result, _ in good for e in result["errors"] if e["phenomenon"] == aim.phenomenon]
    if errors:
        rms = math.sqrt(math.fsum(error**2 for error in errors) / len(errors))
        record["measured"] = {"cost_s": min(cost["cpu_s"] for _, cost in good), "error": rms}
    return record


def prediction_line(record: Mapping[str, Any]) -> str:
    """One prediction with its score, in words."""
    wish = (
        f"{100 * record['target_error']:g} % error"
        if record["target_error"] is not None
        else f"{record['budget_s']:g} CPU s"
    )
    name = {"tracer": "the tracer", "povray": "POV-Ray"}[record["engine"]]
    start = f"{record['phenomenon'].replace('_', ' ')}, {wish}, {name}: {record['label']}"
    if record["measured"] is None:
        return start
    said, was = record["predicted"], record["measured"]
    return (
        f"{start}: predicted {100 * said['error']:.2g} % in {said['cost_s']:.2g} CPU s,"
        f" measured {100 * was['error']:.2g} % in {was['cost_s']:.2g} CPU s"
    )
