"""Images that have passed their gates, with pictures for the eye beside them."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.images.exr import ImageError, ImageLayers, read_image
from vitrail.judge.gates import Inspected, check_gates
from vitrail.judge.pictures import write_pictures
from vitrail.judge.records import SceneResult, Status
from vitrail.judge.stored import Stored
from vitrail.pipeline.record_parts import engine_record, speed_records
from vitrail.pipeline.scene_record import ended

DARK = "no light reaches what the camera sees: every picture is black; turn a lamp to it, or take down what is between"


def open_images(
    record: SceneResult, made: Mapping[str, Rendering], stored: Stored | None, place: Path, times: int = 1
) -> tuple[SceneResult, dict[str, ImageLayers]]:
    """The images by side, and the record with how they were made, what the gates say, and their pictures in ``place``.

    ``times`` is how many pixels the pictures have for one of the scene, along an edge. A closed gate ends the record.
    Raises EngineFailure for an image that cannot be read.
    """
    engines = tuple(engine_record(rendering.record) for rendering in made.values())
    remarks = stored.remarks(engines[0].version) if stored is not None else ()
    record = changed(
        record, engines=engines, speed=speed_records(engines), warnings=(*record.warnings, *remarks, *said(made))
    )
    files = {side: rendering.image_path for side, rendering in made.items()}
    images = {side: read(side, path) for side, path in files.items()}
    if stored is not None:
        images["stored"], files["stored"] = stored.image, place / "stored.exr"
        shutil.copyfile(stored.path, files["stored"])
    inspected = [inspect(side, image, files[side].name) for side, image in images.items()]
    gates = check_gates(record.width, record.height, record.scene_hash, inspected)
    record = changed(record, gates=gates)
    failed = [gate.message for gate in gates if not gate.passed]
    if failed and {gate.gate for gate in gates if not gate.passed} == {"light"} and len(failed) == len(inspected):
        return ended(record, Status.SCENE_ERROR, DARK), images
    if failed:
        return ended(record, Status.ENGINE_FAILED, "\n".join(failed)), images
    sides, differences = write_pictures(images, files, place, record.exposure_stops, times)
    return changed(record, images=sides, differences=differences), images


def said(made: Mapping[str, Rendering]) -> tuple[str, ...]:
    """What the engines warn of in their run records."""
    return tuple(f"{side}: {warning}" for side, each in made.items() for warning in each.record.get("warnings", ()))


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
        halves=None if image.half_a is None or image.half_b is None else (image.half_a, image.half_b),
        metadata={key: str(value) for key, value in image.metadata.items()},
    )


def read(side: str, path: Path) -> ImageLayers:
    """An engine's image. Raises EngineFailure where there is none to be read."""
    try:
        return read_image(path)
    except ImageError as error:
        raise EngineFailure(side, f"its image cannot be read ({error})", "render it again") from None
