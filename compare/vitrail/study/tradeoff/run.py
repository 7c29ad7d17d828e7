"""The study as a whole: matrix, tasks, rows, analysis; resumed from whatever is already in its folder."""

from __future__ import annotations

import threading
from pathlib import Path

from vitrail.base.engine_name import EngineName
from vitrail.base.progress import Progress, silent
from vitrail.base.record import write_record
from vitrail.engines.engine_build import engine_build
from vitrail.judge.references import read_scene_truth, references_folder
from vitrail.pipeline.campaign import Campaign, run_campaign
from vitrail.pipeline.job import prepare
from vitrail.pipeline.task import Task
from vitrail.pipeline.task_log import read_rows
from vitrail.plan.gather_radius import USUAL_PHOTONS
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash
from vitrail.study.tradeoff.analysis import analyse_rows
from vitrail.study.tradeoff.converged import Converged
from vitrail.study.tradeoff.knobs import Extent, matrix
from vitrail.study.tradeoff.measure import Measure
from vitrail.study.tradeoff.records import Tradeoff


class NothingObserved(Exception):
    """The scene observes nothing, so there is no error to measure."""


def run_tradeoff(
    loaded: Loaded,
    out: Path,
    *,
    extent: Extent = "normal",
    jobs: int = 1,
    references: Path | None = None,
    progress: Progress = silent,
) -> Tradeoff:
    """Measure what is missing in ``out``, analyse, write tradeoff.json; returns its content. Raises NothingObserved."""
    tasks = tradeoff_tasks(loaded, extent)
    measure, converged = measure_of(loaded, out, extent, references)
    if converged is not None:
        # Two images are compared pixel by pixel: those of another size cannot be held against the converged one.
        same_size = [task for task in tasks if "image_scale" not in task.spec["wishes"]]
        tasks = [converged.task, *(_against(task, converged.task.key) for task in same_size)]
    work = {"setting": measure.setting, "reference": measure.reference}
    run_campaign(Campaign(tasks, work), out, jobs=jobs, progress=progress)
    return analyse_folder(loaded, out)


def measure_of(loaded: Loaded, out: Path, extent: Extent, references: Path | None) -> tuple[Measure, Converged | None]:
    """How errors are measured on this scene: against its closed forms, else against a converged rendering."""
    if not loaded.scene.observe:
        raise NothingObserved(f"{loaded.path}: observes nothing; add an `observe` entry for what should be accurate")
    truth = read_scene_truth(references_folder(loaded.path, references), loaded.path.stem, loaded.scene)
    if truth.truths:
        return Measure(loaded, truth), None
    converged = Converged(loaded, extent, engine_build(EngineName.TRACER), out / "reference", threading.Lock())
    return Measure(loaded, truth, converged), converged


def tradeoff_tasks(loaded: Loaded, extent: Extent) -> list[Task]:
    """One task a setting and seed; the builds of the engines are part of their keys."""
    usual = prepare(loaded, Quality.NORMAL, {"photons": USUAL_PHOTONS})
    builds = {engine: engine_build(engine) for engine in EngineName}
    return [
        Task(
            "setting",
            {
                "scene": scene_hash(loaded.scene),
                "engine": knobs.engine,
                "build": builds[knobs.engine],
                "settings": dict(knobs.settings),
                "wishes": dict(knobs.wishes),
                "seed": knobs.seed,
            },
        )
        for knobs in matrix(usual, extent)
    ]


def _against(task: Task, reference: str) -> Task:
    """The same task, held against the converged rendering of that key."""
    return Task(task.kind, {**task.spec, "reference": reference})


def analyse_folder(loaded: Loaded, out: Path) -> Tradeoff:
    """Analyse the stored samples again, without rendering."""
    found = analyse_rows(read_rows(out), loaded.path.stem, loaded.scene.title)
    write_record(found, out / "tradeoff.json")
    return found
