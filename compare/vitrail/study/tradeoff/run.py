"""The study as a whole: matrix, tasks, rows, analysis; resumed from whatever is already in its folder."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from vitrail.engines.povray import Povray
from vitrail.engines.tracer import Tracer
from vitrail.judge.references import read_scene_truth, references_folder
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import USUAL_PHOTONS, settings_for
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash
from vitrail.study.queue import Progress, run_tasks
from vitrail.study.task import Task
from vitrail.study.task_log import TaskLog, read_rows
from vitrail.study.tradeoff.analysis import analyse_rows
from vitrail.study.tradeoff.knobs import Extent, matrix
from vitrail.study.tradeoff.measure import Measure


class NoTruth(Exception):
    """The scene has no closed form to measure an error against."""


def run_tradeoff(
    loaded: Loaded,
    out: Path,
    *,
    extent: Extent = "normal",
    jobs: int = 1,
    references: Path | None = None,
    report: Callable[[Progress], None] = lambda progress: None,
) -> dict[str, Any]:
    """Measure what is missing in ``out``, analyse, write tradeoff.json; returns its content. Raises NoTruth."""
    truth = read_scene_truth(references_folder(loaded.path, references), loaded.path.stem, loaded.scene)
    if not truth.truths:
        raise NoTruth(f"{loaded.path}: references/analytic.yaml has no closed form for this scene; add one")
    tasks = tradeoff_tasks(loaded, extent)
    run_tasks(tasks, TaskLog(out), {"setting": Measure(loaded, truth)}, jobs=jobs, report=report)
    return analyse_folder(loaded, out)


def tradeoff_tasks(loaded: Loaded, extent: Extent) -> list[Task]:
    """One task a setting and seed; engine versions are part of their keys."""
    plan = analyse(loaded.scene)
    usual = settings_for(loaded.scene, plan, "normal", photons=USUAL_PHOTONS)
    versions = {"tracer": Tracer().version(), "povray": Povray().version()}
    return [
        Task(
            "setting",
            {
                "scene": scene_hash(loaded.scene),
                "engine": knobs.engine,
                "version": versions[knobs.engine],
                "settings": dict(knobs.settings),
                "transport": dict(knobs.transport),
                "seed": knobs.seed,
            },
        )
        for knobs in matrix(plan, usual.gather_radius_m, extent)
    ]


def analyse_folder(loaded: Loaded, out: Path) -> dict[str, Any]:
    """Analyse the stored samples again, without rendering."""
    found = {"scene": loaded.path.stem, "title": loaded.scene.title, **analyse_rows(read_rows(out))}
    (out / "tradeoff.json").write_text(json.dumps(found, indent=1, sort_keys=True, allow_nan=False) + "\n")
    return found
