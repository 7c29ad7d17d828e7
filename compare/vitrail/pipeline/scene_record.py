"""What ``results.json`` says of a scene before its images are looked at, and when it came to no verdict."""

from __future__ import annotations

from pathlib import Path

from vitrail.base.changed import changed
from vitrail.judge.records import SceneResult, Status
from vitrail.pipeline.job import Job
from vitrail.pipeline.record_parts import plan_records
from vitrail.pipeline.request import Request
from vitrail.plan.views import PICTURE_WIDTH
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash

AGAINST = {
    frozenset(): "truth",
    frozenset({"povray"}): "povray",
    frozenset({"stored"}): "stored",
    frozenset({"povray", "stored"}): "both",
}
"""What a request may hold the tracer against, and the word for it on the command line."""


def record_of_scene(loaded: Loaded, name: str, again: str) -> SceneResult:
    """What is known of a scene before anything is looked at; it waits for a status. ``again`` repeats it."""
    scene = loaded.scene
    return SceneResult(
        name=name,
        title=scene.title,
        source=str(loaded.path),
        scene_hash=scene_hash(scene),
        status=Status.JUDGED,
        width=scene.image.width,
        height=scene.image.height,
        exposure_stops=scene.image.exposure_stops,
        reproduce=again,
        exit_code=0,
    )


def record_of_job(job: Job, name: str, request: Request) -> SceneResult:
    """What is known before anything is rendered: the scene, its plan, and the settings."""
    again = reproduce(job.loaded.path, job.settings.quality, request)
    planned = {
        "plan": plan_records(job.plan),
        "settings": job.settings.as_record(),
        "warnings": job.plan.warnings,
        "width": job.scene.image.width,
        "height": job.scene.image.height,
    }
    return changed(record_of_scene(job.loaded, name, again), **planned)


def ended(record: SceneResult, status: Status, message: str) -> SceneResult:
    """The record of a scene that came to no verdict."""
    return changed(record, status=status, message=message)


def reproduce(path: Path, quality: str, request: Request) -> str:
    """The line that makes this scene's numbers again."""
    options = " ".join(f"--set {key}={value}" for key, value in sorted(request.overrides.items()))
    line = f"vitrail compare {path} --out out --quality {quality} {options}".rstrip()
    if not request.views and "stored" not in request.against:
        line += " --no-views"
    elif request.picture_width != PICTURE_WIDTH:
        line += f" --picture-width {request.picture_width}"
    if request.against != ("povray",):
        line += f" --against {AGAINST[frozenset(request.against)]}"
    return line + (f" --inject-defect {request.defect.name}" if request.defect.name else "")
