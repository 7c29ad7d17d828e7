"""Lower one scene for both engines and render it in both, each image once for each content."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from vitrail.base.canonical_json import canonical_json
from vitrail.base.engine_name import EngineName
from vitrail.base.progress import Progress
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.engines.cache import Cache, content_key, named_files
from vitrail.engines.engine_build import build_of
from vitrail.lower.povray import PovrayScene
from vitrail.lower.povray.certificate.certificate import Certificate
from vitrail.pipeline.job import Job
from vitrail.pipeline.request import Request
from vitrail.scene.print import scene_hash

CERTAIN = 100
"""Photons that cannot all be missing by chance: e^-10 even where POV-Ray aims at ten times as wide a place."""


@dataclass(frozen=True)
class Lowered:
    """One scene in the two forms that the engines take, with the request's defect already in."""

    tracer: dict[str, Any]
    povray: PovrayScene | None

    @property
    def certificate(self) -> Certificate:
        """What the translation changes; nothing where there is none."""
        return self.povray.certificate if self.povray is not None else Certificate(())


def lower_both(job: Job, request: Request) -> Lowered:
    """The tracer's form, and POV-Ray's if the request wants it.

    Raises NotTranslatable with the scene's lines, and NothingToEdit where the request's defect changes nothing.
    """
    defect, scene = request.defect, job.scene
    tracer = job.with_scene(defect.misread_by_tracer(scene)).lowered(EngineName.TRACER)
    # A misread scene is still meant to be this one: both images carry its hash.
    tracer["scene_hash"] = scene_hash(scene)
    if "povray" not in request.against:
        return Lowered(defect.tracer(tracer), None)
    povray = job.with_scene(defect.misread_by_povray(scene)).lowered(EngineName.POVRAY)
    povray = replace(povray, scene_hash=scene_hash(scene))
    return Lowered(defect.tracer(tracer), defect.povray(povray))


def render_both(lowered: Lowered, place: Path, request: Request, progress: Progress) -> dict[str, Rendering]:
    """The images in ``place``: tracer.exr and povray.exr with their run records. Raises EngineFailure.

    Also when POV-Ray's photons all went astray: see ``check_photons``.
    """
    made = {"tracer": _render("tracer", lowered.tracer, tracer_key, place, request, progress)}
    if lowered.povray is not None:
        made["povray"] = _render("povray", lowered.povray, povray_key, place, request, progress)
        # Photons between diffuse surfaces are the tracer's alone.
        if lowered.tracer["transport"]["indirect"] != "photons":
            check_photons(made["tracer"].record, made["povray"].record)
    return made


def check_photons(tracer: dict[str, Any], povray: dict[str, Any]) -> None:
    """Raises EngineFailure where POV-Ray stored no photon though the tracer's share of it were ``CERTAIN`` photons.

    Where the tracer stores none or next to none either, all light leaves the scene, and that is right.
    """
    ours, theirs = tracer.get("counters", {}), povray.get("counters", {})
    stored, emitted = ours.get("photons_stored") or 0, ours.get("photons_emitted") or 0
    shot = theirs.get("photons_emitted") or 0
    if shot and emitted and not theirs.get("photons_stored") and shot * stored / emitted > CERTAIN:
        what = f"it shot {shot} photons and stored none, where the tracer stored {stored} of {emitted}"
        remedy = "this is a defect of the translation or of POV-Ray; report it with the scene"
        raise EngineFailure("povray", what, remedy)


def tracer_key(build: str, lowered: dict[str, Any]) -> str:
    """The content that decides the tracer's image: its input, and the meshes and images that the input names."""
    return content_key("tracer", build, [canonical_json(lowered)], named_files(lowered))


def povray_key(build: str, lowered: PovrayScene | None) -> str:
    """The content that decides POV-Ray's image: the texts of its runs, and how their images are added up.

    The scene's hash is in it too, because the image carries it: two scenes may have one text.
    """
    if lowered is None:
        return ""
    sums = [f"{run.name} {run.half} {run.width} {run.height} {run.samples_across} {run.gain}" for run in lowered.runs]
    return content_key(
        "povray",
        build,
        [
            lowered.scene_hash,
            *sums,
            *(text for run in lowered.runs for text in run.texts.values()),
            str(lowered.settings),
        ],
    )


def _render(
    side: str,
    lowered: Any,
    key: Callable[[str, Any], str],
    place: Path,
    request: Request,
    progress: Progress,
) -> Rendering:
    """One image, from the cache where its content is known; its files are linked into the scene's folder."""
    engine = request.engines[side]
    made = Cache(request.cache).rendered(
        key(build_of(engine), lowered),
        lambda work: engine.render(lowered, work, threads=request.threads, progress=progress),
    )
    place.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(place / side, ignore_errors=True)
    for path in sorted(made.image_path.parent.rglob("*")):
        if path.is_file() and path.name != "record.json":
            _link(path, place / path.relative_to(made.image_path.parent))
    return Rendering(place / made.image_path.name, made.record)


def _link(source: Path, target: Path) -> None:
    """A second name for a kept file, or a copy where the folder's disk has no links."""
    target.parent.mkdir(parents=True, exist_ok=True)
    target.unlink(missing_ok=True)
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)
