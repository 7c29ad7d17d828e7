"""The main line: every scene planned, lowered, run in both engines and measured; then all judged together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.base.progress import Progress, named, silent
from vitrail.engines.base import EngineFailure, Rendering, records_of
from vitrail.judge.judgement import Residual
from vitrail.judge.lost_light import lost_light
from vitrail.judge.observe import NothingToMeasure
from vitrail.judge.records import Results, SceneResult, Status
from vitrail.judge.references import references_folder
from vitrail.judge.scan import scan_images
from vitrail.judge.stored import Stored, read_stored
from vitrail.lower.povray import NothingToEdit, NotTranslatable
from vitrail.pipeline.ablate import search_whereabouts
from vitrail.pipeline.gated_images import open_images
from vitrail.pipeline.gated_views import open_views
from vitrail.pipeline.job import Job, prepare
from vitrail.pipeline.look_again import look_again, request_of
from vitrail.pipeline.lowered import Lowered, job_of, lower
from vitrail.pipeline.measurements import Measurements
from vitrail.pipeline.own_defect import TRACEBACK, defective, if_own_defect, unsearched
from vitrail.pipeline.request import Request
from vitrail.pipeline.run_both import run_both
from vitrail.pipeline.scene_record import ended, record_of_job
from vitrail.pipeline.scene_run import SceneRun, SceneTask
from vitrail.pipeline.scheduler import run_each
from vitrail.pipeline.suite import Suite
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash


def compare(scenes: Sequence[Loaded], request: Request, progress: Progress = silent) -> Results:
    """Run every scene, judge all, write ``results.json`` after each, and return the results.

    Ctrl-C keeps what has finished: the results are marked interrupted and hold those scenes. A defect of this program
    is the end of the scene that met it, and of no other.
    """
    suite, work = Suite.begin(scenes, request), partial(_look, progress=progress)
    try:
        run_each(suite.tasks(), work, suite.keep, jobs=request.jobs)
        for _ in range(request.rounds):
            run_each(suite.more_samples(), work, suite.keep, jobs=request.jobs)
        for record in suite.deviating():
            suite.keep_search(record.name, _with_whereabouts(suite, record, progress))
    except KeyboardInterrupt:
        suite.interrupted = True
    return suite.results()


def compare_scene(task: SceneTask, progress: Progress = silent) -> SceneRun:
    """Plan, lower, run, measure. What stops one scene is its status and message, and stops no other.

    Raises KeyboardInterrupt where somebody stopped an engine.
    """
    loaded, place = task.loaded, task.request.out / task.name
    request = task.request if task.purchase is None else request_of(task, task.purchase)
    references = references_folder(loaded.path, request.references)
    stored = _stored(loaded, references, request)
    job = _prepared(loaded, stored, request)
    record = record_of_job(job, task.name, request)
    try:
        if task.purchase is not None and "" not in task.purchase.samples:
            return look_again(task, task.purchase, references, progress)
        lowered = lower(job, request)
        record = changed(record, certificate=lowered.certificate.records)
        rendered = run_both(lowered, place, request, progress)
        record, images = open_images(record, rendered, stored, place, job.times)
        if record.status is Status.JUDGED:
            record, views = open_views(record, job.scene, job.views, rendered, place)
        if record.status is not Status.JUDGED:
            return SceneRun(record)
        name = loaded.path.stem
        measured = Measurements(job.scene, name, references, job.settings, images, stored, views, job.times)
        scanned = scan_images(job.world, images, _allowed(lowered, rendered), place)
        record = changed(record, global_metrics=measured.whole_images(), scan=scanned)
        return SceneRun(record, measured.observations(), lowered.certificate.bound, references)
    except NotTranslatable as refusal:
        return SceneRun(ended(record, Status.NOT_TRANSLATABLE, str(refusal)))
    except EngineFailure as failure:
        return SceneRun(ended(record, Status.ENGINE_FAILED, str(failure)))
    except NothingToEdit as nothing:
        return SceneRun(ended(record, Status.SCENE_ERROR, f"{request.defect.name}: {nothing}; leave it out"))
    except NothingToMeasure as nothing:
        return SceneRun(ended(record, Status.SCENE_ERROR, str(nothing)))


def _allowed(lowered: Lowered, made: Mapping[str, Rendering]) -> Residual:
    """What the whole pictures may differ by: what the certificate states, and what the engines lose of the light."""
    lost = lost_light(records_of(made), None)
    return lambda phenomenon, whole: lowered.certificate.bound(phenomenon, whole) + lost.cut + lost.unstated


def _stored(loaded: Loaded, references: Path, request: Request) -> Stored | None:
    """The scene's accepted image, where the request holds the tracer against it."""
    return read_stored(references, loaded.path.stem, scene_hash(loaded.scene)) if "stored" in request.against else None


def _prepared(loaded: Loaded, stored: Stored | None, request: Request) -> Job:
    """The scene with the request's settings, or by the recipe of the stored image where that is to be made again."""
    if stored is None:
        return job_of(loaded, request)
    recipe = {key: value for key, value in stored.provenance.settings.items() if key != "quality"}
    return prepare(loaded, Quality(stored.provenance.quality), {**recipe, **request.overrides})


def _look(task: SceneTask, progress: Progress) -> SceneRun:
    """A scene's run; a defect of this program that it meets is its end, and that of no other scene."""
    (task.request.out / task.name / TRACEBACK).unlink(missing_ok=True)
    return if_own_defect(
        lambda: compare_scene(task, named(progress, task.name)),
        lambda error: SceneRun(defective(task, error)),
    )


def _with_whereabouts(suite: Suite, record: SceneResult, progress: Progress) -> SceneRun:
    """The run with what was tried to find where its engines deviate; a defect met there takes no verdict away."""
    run, loaded, left_s = suite.runs[record.name], suite.scenes[record.name], suite.left_s
    assert run.references is not None
    references, watched = run.references, named(progress, record.name)

    def unfound(error: Exception) -> SceneRun:
        warnings = (*run.record.warnings, unsearched(record, suite.request, error))
        return replace(run, record=changed(run.record, warnings=warnings))

    return if_own_defect(
        lambda: replace(run, search=search_whereabouts(loaded, references, record, suite.request, left_s, watched)),
        unfound,
    )
