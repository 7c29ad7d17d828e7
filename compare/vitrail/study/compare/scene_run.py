"""One scene on its way from its file to numbers that wait for their verdict."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

from vitrail.engines.base import EngineFailure, Progress, Rendering
from vitrail.images.exr import ImageError, ImageLayers, read_image
from vitrail.judge.comparison import Pair
from vitrail.judge.gates import Inspected, check_gates
from vitrail.judge.observe import NothingToMeasure, Observed, observe
from vitrail.judge.pictures import write_pictures
from vitrail.judge.records import Gate, SceneResult, Status
from vitrail.judge.references import read_scene_truth, references_folder
from vitrail.judge.whole_image import global_metrics
from vitrail.lower.povray import NotTranslatable
from vitrail.lower.povray.certificate import Certificate
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import Settings, settings_for
from vitrail.plan.plan import Plan
from vitrail.scene.load import Loaded
from vitrail.scene.phenomenon import Phenomenon
from vitrail.scene.print import scene_hash
from vitrail.study.compare.evidence import certificate_records, engine_record, plan_records, speed_records
from vitrail.study.compare.render import lower_both, render_both
from vitrail.study.compare.request import Request

PAIRS = (Pair.TRACER_POVRAY, Pair.TRACER_TRUTH, Pair.POVRAY_TRUTH)


@dataclass(frozen=True)
class SceneRun:
    """A scene's record without verdicts, its numbers, and what the certificate allows for each phenomenon."""

    record: SceneResult
    observed: tuple[Observed, ...] = ()
    residual: Callable[[Phenomenon], float] = lambda phenomenon: 0.0
    references: Path | None = None


def run_scene(loaded: Loaded, name: str, request: Request, progress: Progress) -> SceneRun:
    """Load, plan, lower, render, measure. What stops one scene is its status and message, and stops no other."""
    plan = analyse(loaded.scene)
    settings = settings_for(loaded.scene, plan, request.quality, **request.overrides)
    record = _record(loaded, name, plan, settings, request)
    try:
        lowered = lower_both(loaded, plan, settings, request)
        record = record.model_copy(update={"certificate": certificate_records(lowered.povray.certificate)})
        made = render_both(lowered, request.out / name, request, progress)
        return _measured(loaded, record, made, lowered.povray.certificate, settings, request)
    except NotTranslatable as refusal:
        return SceneRun(ended(record, Status.NOT_TRANSLATABLE, str(refusal)))
    except EngineFailure as failure:
        return SceneRun(ended(record, Status.ENGINE_FAILED, str(failure)))
    except NothingToMeasure as nothing:
        return SceneRun(ended(record, Status.SCENE_ERROR, str(nothing)))


def ended(record: SceneResult, status: Status, message: str) -> SceneResult:
    """The record of a scene that came to no verdict."""
    return record.model_copy(update={"status": status, "message": message})


def _record(loaded: Loaded, name: str, plan: Plan, settings: Settings, request: Request) -> SceneResult:
    """What is known before anything is rendered."""
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
        plan=plan_records(plan),
        settings=asdict(settings),
        warnings=plan.warnings,
        reproduce=_reproduce(loaded.path, settings, request),
        exit_code=0,
    )


def _measured(
    loaded: Loaded,
    record: SceneResult,
    made: Mapping[str, Rendering],
    certificate: Certificate,
    settings: Settings,
    request: Request,
) -> SceneRun:
    """Gates, pictures, whole-image metrics and observations of two finished images."""
    engines = tuple(engine_record(rendering.record) for rendering in made.values())
    record = record.model_copy(update={"engines": engines, "speed": speed_records(engines)})
    if any(rendering.interrupted for rendering in made.values()):
        return SceneRun(ended(record, Status.INTERRUPTED, "interrupted; start again to finish it"))
    images, gates = _images(record, made)
    record = record.model_copy(update={"gates": gates})
    failed = [gate.message for gate in gates if not gate.passed]
    if failed:
        return SceneRun(ended(record, Status.ENGINE_FAILED, "\n".join(failed)))
    place = request.out / record.name
    files, differences = write_pictures(images, made_paths(made), place, loaded.scene.image.exposure_stops)
    folder = references_folder(loaded.path, request.references)
    truth = read_scene_truth(folder, loaded.path.stem, loaded.scene)
    observed = observe(loaded.scene, images, PAIRS, truth, settings.gather_radius_m)
    record = record.model_copy(
        update={
            "images": files,
            "differences": differences,
            "global_metrics": global_metrics(images, loaded.scene.image.exposure_stops),
        }
    )
    return SceneRun(record, observed, certificate.bound, folder)


def made_paths(made: Mapping[str, Rendering]) -> dict[str, Path]:
    return {side: rendering.image_path for side, rendering in made.items()}


def _images(record: SceneResult, made: Mapping[str, Rendering]) -> tuple[dict[str, ImageLayers], tuple[Gate, ...]]:
    """Read both images and pass them through the gates. Raises EngineFailure for one that cannot be read."""
    images = {}
    for side, rendering in made.items():
        try:
            images[side] = read_image(rendering.image_path)
        except ImageError as error:
            raise EngineFailure(side, f"its image cannot be read ({error})", "render it again") from None
    inspected = [inspect(side, image, made[side].image_path.name) for side, image in images.items()]
    return images, check_gates(record.width, record.height, record.scene_hash, inspected)


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


def _reproduce(path: Path, settings: Settings, request: Request) -> str:
    """The line that makes this scene's numbers again."""
    options = " ".join(f"--set {key}={value}" for key, value in sorted(request.overrides.items()))
    line = f"vitrail compare {path} --out out --quality {settings.quality} {options}".rstrip()
    return line + (f" --inject-defect {request.defect.name}" if request.defect.name else "")
