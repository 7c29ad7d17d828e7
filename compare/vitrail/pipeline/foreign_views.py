"""Views for any renderer: a list of the pictures to make with a scene file for each, and the pictures that it made.

They are judged like those of our own engines, by the same gates and the same metrics.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import JsonValue

from vitrail.base.canonical_json import canonical_json
from vitrail.base.changed import changed
from vitrail.base.engine_name import EngineName
from vitrail.base.record import json_text
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.images.exr import ImageError
from vitrail.judge.records import SceneResult, Status
from vitrail.judge.shown import Shown
from vitrail.pipeline.gated_views import open_views
from vitrail.pipeline.job import Job
from vitrail.pipeline.scene_record import ended
from vitrail.plan.views import ObservationView
from vitrail.scene.print import scene_hash

LIST = "views.json"
"""What to make: names, sizes, cameras, and what each file is to be called."""

WHOLE = "scene.json"
"""The scene's own picture with all its views, as the tracer reads it."""


def emitted_views(job: Job) -> dict[str, str]:
    """File name to text: the list, a scene file for each view, and the whole for our own tracer.

    A view's file is what ``emit tracer`` writes, with the camera and the size of the view.
    """
    meant = {"scene_hash": scene_hash(job.loaded.scene)}
    whole = {**job.with_views().lowered(EngineName.TRACER), **meant}
    views = job.with_views().views
    lowered = {each["name"]: each for each in whole.get("views", ())}
    entries = [_entry(view, lowered[view.name]) for view in views]
    files = {entry["scene"]: canonical_json(_scene_of(whole, lowered[entry["name"]])) for entry in entries}
    told: dict[str, JsonValue] = {"vitrail_views": 1, "title": job.scene.title, **meant, "views": [*entries]}
    return {LIST: json_text(told, indent=2), WHOLE: canonical_json(whole), **files}


def _entry(view: ObservationView, lowered: Mapping[str, Any]) -> dict[str, Any]:
    """One picture to make; ``image`` is the file that ``score --views`` reads."""
    return {
        "name": view.name,
        "observations": list(view.observations),
        "scene": f"{view.name}.json",
        "image": f"{view.name}.exr",
        "width": view.image.width,
        "height": view.image.height,
        "samples": view.samples,
        "camera": lowered["camera"],
    }


def _scene_of(whole: Mapping[str, Any], view: Mapping[str, Any]) -> dict[str, Any]:
    """The lowered scene as one view sees it."""
    alone = {key: value for key, value in whole.items() if key != "views"}
    alone |= {"image": view["image"], "camera": view["camera"]}
    return {**alone, "settings": {**whole["settings"], "samples": view["samples"]}}


# --- what was made --------------------------------------------------------------------------------------------------


def foreign_views(
    job: Job, record: SceneResult, folders: Mapping[str, Path], place: Path
) -> tuple[SceneResult, dict[str, Shown]]:
    """What each side made for each observation; copies and pictures are in ``place``. A closed gate ends the record.

    Raises ImageError for a picture that is missing.
    """
    views = job.with_views().views
    made = {side: _made(side, folder, views, place) for side, folder in folders.items()}
    try:
        record, shown = open_views(record, job.scene, views, made, place)
    except EngineFailure as failure:
        return ended(record, Status.GATE_FAILED, str(failure)), {}
    # What another program made wrong is no failure of an engine of ours.
    closed = record.status is Status.ENGINE_FAILED
    return (changed(record, status=Status.GATE_FAILED) if closed else record), shown


def _made(side: str, folder: Path, views: tuple[ObservationView, ...], place: Path) -> Rendering:
    """One side's pictures, copied beside the results."""
    missing = [f"{view.name}.exr" for view in views if not (folder / f"{view.name}.exr").is_file()]
    if missing:
        raise ImageError(folder, f"lacks {', '.join(missing)}", "render what `vitrail emit views` lists")
    place.mkdir(parents=True, exist_ok=True)
    copies = {view.name: place / f"{side}.{view.name}.exr" for view in views}
    for name, copy in copies.items():
        copy.write_bytes((folder / f"{name}.exr").read_bytes())
    return Rendering(place / f"{side}.exr", {}, copies)
