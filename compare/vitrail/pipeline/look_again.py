"""Another look at the views of a scene that are open, with what was bought for them; all else stays as it was."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from vitrail.base.changed import changed
from vitrail.base.progress import Progress
from vitrail.base.record import number_in
from vitrail.judge.noise_record import learnt
from vitrail.judge.observe import Observed, observe
from vitrail.judge.purchase import Purchase
from vitrail.judge.records import EngineRun, SceneResult, Status
from vitrail.judge.references import read_scene_truth
from vitrail.pipeline.gated_views import open_views
from vitrail.pipeline.lowered import job_of, lower
from vitrail.pipeline.measurements import PAIRS
from vitrail.pipeline.prices import paid_s
from vitrail.pipeline.record_parts import engine_record
from vitrail.pipeline.request import Request
from vitrail.pipeline.run_both import run_both
from vitrail.pipeline.scene_record import record_of_job
from vitrail.pipeline.scene_run import SceneRun, SceneTask


def request_of(task: SceneTask, purchase: Purchase) -> Request:
    """The request of a task with what was bought: photons, and samples of the picture; those of views are the job's."""
    bought: dict[str, object] = {"photons": purchase.photons} if purchase.photons else {}
    if "" in purchase.samples:
        bought["samples"] = purchase.samples[""]
    return replace(task.request, overrides={**task.request.overrides, **bought})


def look_again(task: SceneTask, purchase: Purchase, references: Path, progress: Progress) -> SceneRun:
    """The numbers of the views that were paid for, and how they were made.

    Raises EngineFailure, NotTranslatable and NothingToMeasure, as the first look does.
    """
    request = request_of(task, purchase)
    job = job_of(task.loaded, request).only(purchase.samples)
    place = request.out / task.name / f"look_{task.look}"
    record = record_of_job(job, task.name, request)
    lowered = lower(job, request)
    rendered = run_both(lowered, place, request, progress)
    record = changed(record, engines=tuple(engine_record(made.record) for made in rendered.values()))
    record, views = open_views(record, job.scene, job.views, rendered, place, request.out)
    if record.status is not Status.JUDGED:
        return SceneRun(record)
    truth = read_scene_truth(references, task.loaded.path.stem, task.loaded.scene)
    radius_m = job.settings.gather_radius_m
    # Outlines in the scene's picture are known from the first look; this one has a token in its place.
    found = observe(task.loaded.scene, {}, PAIRS, truth, radius_m, views, only=frozenset(views))
    return SceneRun(record, found, lowered.certificate.bound, references)


def with_look(older: SceneRun, newer: SceneRun, purchase: Purchase) -> SceneRun:
    """A run with the numbers of another look in the place of its own; a look that failed is a remark."""
    paid = changed(purchase, paid_s=paid_s(newer.record.engines))
    record = changed(older.record, purchases=(*older.record.purchases, paid))
    if newer.record.status is not Status.JUDGED:
        remark = f"more samples were bought and gave no numbers: {newer.record.message}"
        return replace(older, record=changed(record, warnings=(*record.warnings, remark)))
    if "" in purchase.samples:
        return replace(newer, record=changed(newer.record, purchases=record.purchases))
    fresh = {entry.observation.name: entry for entry in newer.observed}
    observed = tuple(
        _seen_again(entry, fresh[entry.observation.name], older.record, purchase)
        if entry.observation.name in fresh
        else entry
        for entry in older.observed
    )
    return replace(older, record=record, observed=observed)


def _seen_again(older: Observed, newer: Observed, record: SceneResult, purchase: Purchase) -> Observed:
    """An observation in another look: its patch in the scene's own picture, and causes of noise as both looks show."""
    found = replace(newer, patch=older.patch)
    if older.view is None or newer.view is None:
        return found
    photons = number_in(record.settings, "photons", 0.0)
    taken = next((each.photons for each in reversed(record.purchases) if older.view.name in each.samples), photons)
    more_photons = purchase.photons / taken if taken else 1.0
    more_samples = newer.view.samples / older.view.samples
    before = {each.side: each for each in older.noise}
    noise = tuple(
        learnt(before[each.side], each, more_photons, more_samples) if each.side in before else each
        for each in newer.noise
    )
    return replace(found, noise=noise)


def priced(scene: SceneResult, last: SceneResult) -> SceneResult:
    """A scene with the costs of its last look, which took other photons and not all of its views."""
    engines = tuple(
        _with_views(engine, next((each for each in scene.engines if each.engine == engine.engine), engine))
        for engine in last.engines
    )
    settings = {**scene.settings, "photons": last.settings.get("photons", 0)}
    return changed(scene, engines=engines, settings=settings)


def _with_views(engine: EngineRun, first: EngineRun) -> EngineRun:
    """The engine's costs of the last look, with those of the first where a view was not looked at again."""
    views = {view["name"]: view for run in (first, engine) for view in _views(run)}
    return changed(engine, record={**engine.record, "views": list(views.values())})


def _views(engine: EngineRun) -> list[Any]:
    found: Any = engine.record.get("views")
    return list(found or ())
