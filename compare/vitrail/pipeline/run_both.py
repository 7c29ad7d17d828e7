"""Run a lowered scene in both engines, each image once for each content."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

from vitrail.base.progress import Progress, silent
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.engines.cache import Cache
from vitrail.engines.engine_build import build_of
from vitrail.pipeline.content_keys import povray_key, tracer_key
from vitrail.pipeline.lowered import Lowered
from vitrail.pipeline.request import Request
from vitrail.pipeline.run import finished

CERTAIN = 100
"""Photons that cannot all be missing by chance: e^-10 even where POV-Ray aims at ten times as wide a place."""


def run_both(lowered: Lowered, place: Path, request: Request, progress: Progress = silent) -> dict[str, Rendering]:
    """The images in ``place``: tracer.exr and povray.exr with their run records.

    Raises EngineFailure, also when POV-Ray's photons all went astray (see ``check_photons``), and KeyboardInterrupt
    where somebody stopped an engine.
    """
    made = {"tracer": _rendered("tracer", lowered.tracer, place, request, progress)}
    if lowered.povray is not None:
        made["povray"] = _rendered("povray", lowered.povray, place, request, progress)
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


def _rendered(side: str, lowered: Any, place: Path, request: Request, progress: Progress) -> Rendering:
    """One image, from the cache where its content is known; its files are linked into the scene's folder."""
    engine = request.engines[side]
    key_of = tracer_key if side == "tracer" else povray_key
    made = Cache(request.cache).rendered(
        key_of(build_of(engine), lowered),
        lambda work: finished(engine.render(lowered, work, threads=request.threads, progress=progress)),
    )
    place.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(place / side, ignore_errors=True)
    for path in sorted(made.image_path.parent.rglob("*")):
        if path.is_file() and path.name != "record.json":
            _link(path, place / path.relative_to(made.image_path.parent))
    views = {name: place / path.name for name, path in made.views.items()}
    return Rendering(place / made.image_path.name, made.record, views)


def _link(source: Path, target: Path) -> None:
    """A second name for a kept file, or a copy where the folder's disk has no links."""
    target.parent.mkdir(parents=True, exist_ok=True)
    target.unlink(missing_ok=True)
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)
