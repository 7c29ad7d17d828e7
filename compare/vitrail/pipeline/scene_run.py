"""One scene on its way from its file to numbers that wait for their verdict."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from vitrail.base.progress import Progress
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.images.exr import ImageError, ImageLayers, read_image
from vitrail.judge.gates import Inspected, check_gates
from vitrail.judge.judgement import Residual
from vitrail.judge.observe import NothingToMeasure, Observed
from vitrail.judge.pictures import write_pictures
from vitrail.judge.records import SceneResult, Status
from vitrail.judge.references import references_folder
from vitrail.judge.stored import Stored, read_stored
from vitrail.lower.povray import NothingToEdit, NotTranslatable
from vitrail.pipeline.ablate import Search
from vitrail.pipeline.evidence import certificate_records, engine_record, plan_records, speed_records
from vitrail.pipeline.job import Job, prepare
from vitrail.pipeline.look import Look
from vitrail.pipeline.render import lower_both, render_both
from vitrail.pipeline.request import Request
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash

AGAINST = {
    frozenset(): "truth",
    frozenset({"povray"}): "povray",
    frozenset({"stored"}): "stored",
    frozenset({"povray", "stored"}): "both",
}
"""What a request may hold the tracer against, and the word for it on the command line."""


@dataclass(frozen=True)
class SceneRun:
    """A scene's record without verdicts, its numbers, and what the certificate allows for each phenomenon.

    ``search`` is what was tried to find where its engines deviate.
    """

    record: SceneResult
    observed: tuple[Observed, ...] = ()
    residual: Residual = lambda phenomenon, whole_over_light: 0.0
    references: Path | None = None
    search: Search = Search()


def run_scene(loaded: Loaded, name: str, request: Request, progress: Progress) -> SceneRun:
    """Load, plan, lower, render, measure. What stops one scene is its status and message, and stops no other."""
    folder = references_folder(loaded.path, request.references)
    stored = read_stored(folder, loaded.path.stem, scene_hash(loaded.scene)) if "stored" in request.against else None
    job = _prepared(loaded, stored, request)
    record = _record(job, name, request)
    try:
        lowered = lower_both(job, request)
        record = record.model_copy(update={"certificate": certificate_records(lowered.certificate)})
        made = render_both(lowered, request.out / name, request, progress)
        record, images = _images(loaded, record, made, stored, request)
        if record.status is not Status.JUDGED:
            return SceneRun(record)
        look = Look(loaded.scene, loaded.path.stem, folder, job.settings, images, stored)
        record = record.model_copy(update={"global_metrics": look.whole_images()})
        return SceneRun(record, look.observations(), lowered.certificate.bound, folder)
    except NotTranslatable as refusal:
        return SceneRun(ended(record, Status.NOT_TRANSLATABLE, str(refusal)))
    except EngineFailure as failure:
        return SceneRun(ended(record, Status.ENGINE_FAILED, str(failure)))
    except NothingToEdit as nothing:
        return SceneRun(ended(record, Status.SCENE_ERROR, f"{request.defect.name}: {nothing}; leave it out"))
    except NothingToMeasure as nothing:
        return SceneRun(ended(record, Status.SCENE_ERROR, str(nothing)))


def ended(record: SceneResult, status: Status, message: str) -> SceneResult:
    """The record of a scene that came to no verdict."""
    return record.model_copy(update={"status": status, "message": message})


def unjudged(loaded: Loaded, name: str, request: Request) -> SceneResult:
    """What is known of a scene before anything is looked at; it waits for a status."""
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
        reproduce=reproduce(loaded.path, request.quality, request),
        exit_code=0,
    )


def _record(job: Job, name: str, request: Request) -> SceneResult:
    """What is known before anything is rendered."""
    planned = {
        "plan": plan_records(job.plan),
        "settings": job.settings.as_record(),
        "warnings": job.plan.warnings,
        "reproduce": reproduce(job.loaded.path, job.settings.quality, request),
    }
    return unjudged(job.loaded, name, request).model_copy(update=planned)


def _prepared(loaded: Loaded, stored: Stored | None, request: Request) -> Job:
    """The scene with the request's settings, or by the recipe of the stored image where that is to be made again."""
    if stored is None:
        return prepare(loaded, request.quality, request.overrides)
    recipe = {key: value for key, value in stored.provenance.settings.items() if key != "quality"}
    return prepare(loaded, Quality(stored.provenance.quality), {**recipe, **request.overrides})


def _images(
    loaded: Loaded, record: SceneResult, made: Mapping[str, Rendering], stored: Stored | None, request: Request
) -> tuple[SceneResult, dict[str, ImageLayers]]:
    """The images through their gates, with their pictures; the record says how they were made or what is wrong.

    Raises EngineFailure for an image that cannot be read.
    """
    engines = tuple(engine_record(rendering.record) for rendering in made.values())
    remarks = stored.remarks(engines[0].version) if stored is not None else ()
    record = record.model_copy(
        update={"engines": engines, "speed": speed_records(engines), "warnings": (*record.warnings, *remarks)}
    )
    if any(rendering.interrupted for rendering in made.values()):
        return ended(record, Status.INTERRUPTED, "interrupted; start again to finish it"), {}
    files = {side: rendering.image_path for side, rendering in made.items()}
    images = {side: _read(side, path) for side, path in files.items()}
    if stored is not None:
        images["stored"], files["stored"] = stored.image, request.out / record.name / "stored.exr"
        shutil.copyfile(stored.path, files["stored"])
    inspected = [inspect(side, image, files[side].name) for side, image in images.items()]
    gates = check_gates(record.width, record.height, record.scene_hash, inspected)
    record = record.model_copy(update={"gates": gates})
    failed = [gate.message for gate in gates if not gate.passed]
    if failed:
        return ended(record, Status.ENGINE_FAILED, "\n".join(failed)), images
    place = request.out / record.name
    sides, differences = write_pictures(images, files, place, loaded.scene.image.exposure_stops)
    return record.model_copy(update={"images": sides, "differences": differences}), images


def _read(side: str, path: Path) -> ImageLayers:
    try:
        return read_image(path)
    except ImageError as error:
        raise EngineFailure(side, f"its image cannot be read ({error})", "render it again") from None


def inspect(side: str, image: ImageLayers, file: str) -> Inspected:
    """What the gates look at."""
    return Inspected(
        side=side,
        file=file,
        width=image.width,
        height=image.height,
        channels=("R", "G", "B"),
        pixel_type=image.pixel_type,
        radiance=image.radiance,
        metadata={key: str(value) for key, value in image.metadata.items()},
    )


def reproduce(path: Path, quality: str, request: Request) -> str:
    """The line that makes this scene's numbers again."""
    options = " ".join(f"--set {key}={value}" for key, value in sorted(request.overrides.items()))
    line = f"vitrail compare {path} --out out --quality {quality} {options}".rstrip()
    if request.against != ("povray",):
        line += f" --against {AGAINST[frozenset(request.against)]}"
    return line + (f" --inject-defect {request.defect.name}" if request.defect.name else "")
