"""The images of views that have passed their gates, by observation, with pictures for the eye beside them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.engines.base import EngineFailure, Rendering, records_of
from vitrail.images.exr import ImageLayers
from vitrail.judge.gates import check_gates
from vitrail.judge.lost_light import lost_light
from vitrail.judge.pictures import write_view_pictures
from vitrail.judge.records import Gate, SceneResult, Status
from vitrail.judge.shown import Shown, outline_px
from vitrail.judge.view_record import ViewRecord
from vitrail.pipeline.gated_images import inspect, read
from vitrail.pipeline.scene_record import ended
from vitrail.plan.views import ObservationView
from vitrail.scene.model import Scene


def open_views(
    record: SceneResult,
    scene: Scene,
    views: Sequence[ObservationView],
    made: Mapping[str, Rendering],
    place: Path,
    root: Path | None = None,
) -> tuple[SceneResult, dict[str, Shown]]:
    """What was made for each observation, and the record with what the gates say of it; pictures are in ``place``.

    Paths are relative to ``root``, where ``results.json`` is; without it that is the folder above. A closed gate ends
    the record. Raises EngineFailure for an image that is missing or cannot be read.
    """
    root = root or place.parent
    shown: dict[str, Shown] = {}
    gates, failed = [], []
    for view in views:
        files = view_files(view, made)
        images = {side: read(side, path) for side, path in files.items()}
        failures = _failures(view, record.scene_hash, images, files)
        failed += failures
        message = "; ".join(failures) or "passed"
        gates.append(Gate(gate="view", passed=not failures, message=f"{view.name}: {message}"))
        if not failed:
            sides, difference = write_view_pictures(images, files, place, root, view.name, record.exposure_stops)
            drawn = changed(_view_record(view, scene), images=sides, difference_picture=difference)
            shown |= dict.fromkeys(
                view.observations,
                Shown(view.camera, view.image, images, drawn, lost_light(records_of(made), view.name)),
            )
    record = changed(record, gates=(*record.gates, *gates))
    return (ended(record, Status.ENGINE_FAILED, "\n".join(failed)) if failed else record), shown


def read_views(views: Sequence[ObservationView], made: Mapping[str, Rendering]) -> dict[str, Shown]:
    """What was made for each observation, for measuring alone. Raises EngineFailure as ``open_views`` does."""
    shown: dict[str, Shown] = {}
    for view in views:
        images = {side: read(side, path) for side, path in view_files(view, made).items()}
        shown |= dict.fromkeys(
            view.observations, Shown(view.camera, view.image, images, lost=lost_light(records_of(made), view.name))
        )
    return shown


def view_files(view: ObservationView, made: Mapping[str, Rendering]) -> dict[str, Path]:
    """The file of a view by side. Raises EngineFailure where an engine made none."""
    for side, rendering in made.items():
        if view.name not in rendering.views:
            remedy = "report it with the scene, or compare with --no-views"
            raise EngineFailure(side, f"it made no picture of the view `{view.name}`", remedy)
    return {side: rendering.views[view.name] for side, rendering in made.items()}


def _failures(
    view: ObservationView, scene_hash: str, images: Mapping[str, ImageLayers], files: Mapping[str, Path]
) -> list[str]:
    """What closed gates say."""
    inspected = [inspect(side, image, files[side].name) for side, image in images.items()]
    gates = check_gates(view.image.width, view.image.height, scene_hash, inspected, may_be_black=True)
    return [gate.message for gate in gates if not gate.passed]


def _view_record(view: ObservationView, scene: Scene) -> ViewRecord:
    """The camera and the pixels of a view, with its patch in it."""
    patch = next(entry.patch for entry in scene.observe if entry.name in view.observations)
    camera = view.camera
    return ViewRecord(
        name=view.name,
        kind=camera.kind,
        position=camera.position,
        look_at=camera.look_at,
        up=camera.up,
        fov_deg=camera.fov_deg,
        height_m=camera.height,
        width=view.image.width,
        height=view.image.height,
        samples=view.samples,
        outline_px=outline_px(camera, view.image, patch),
    )
