"""The image of all finished passes and its run record, each in its place, whole or not at all."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from vitrail.base.canonical_json import canonical_json
from vitrail.base.whole_file import whole_file, write_whole
from vitrail.images.exr import ImageLayers, write_image
from vitrail.judge.half_error import HalfError
from vitrail.pipeline.passes.checkpoint import Checkpoint
from vitrail.pipeline.passes.error_estimate import mean_blur_m
from vitrail.pipeline.passes.passes_job import PassesJob
from vitrail.pipeline.passes.schedule import gather_radii_m
from vitrail.pipeline.passes.stop import Reason

LAW = "r^2 (i + 1) = r^2 (i) (i + 2/3) / (i + 1)"


def write_output(work: PassesJob, state: Checkpoint, reason: Reason, errors: tuple[HalfError, ...]) -> dict[str, Any]:
    """Write image and record; returns the record."""
    about = _about(work, state, errors)
    record = {
        **state.record,
        "interrupted": reason is Reason.INTERRUPTED,
        "passes": {
            **about,
            "stopped_by": reason.value,
            "noise": list(state.noise),
            "cpu_s": list(state.cpu_s),
            "gather_radius_m": gather_radii_m(work.first_radius_m, state.sums.count),
        },
    }
    with whole_file(work.out) as image:
        _write_image(image, state.sums.mean(), {**state.metadata, "vitrail:passes": json.dumps(about)})
        write_whole(work.out.with_suffix(".run.json"), canonical_json(record))
    return record


def _about(work: PassesJob, state: Checkpoint, errors: tuple[HalfError, ...]) -> dict[str, Any]:
    """What an image says of its passes: the same for the same passes, however many sittings and seconds they took."""
    count = state.sums.count
    return {
        "count": count,
        "radius_law": LAW,
        "first_radius_m": work.first_radius_m,
        "last_radius_m": gather_radii_m(work.first_radius_m, count)[-1],
        "blur_radius_m": mean_blur_m(work, state),
        "relative_noise": state.noise[-1],
        "errors": [_as_record(each) for each in errors],
    }


def _as_record(each: HalfError) -> dict[str, Any]:
    """One number; what is not known is null: JSON has no infinity."""
    record = {**asdict(each), "error": each.error, "pixel_error": each.pixel_error}
    return {key: None if isinstance(v, float) and not math.isfinite(v) else v for key, v in record.items()}


def _write_image(path: Path, image: ImageLayers, metadata: Mapping[str, Any]) -> None:
    write_image(
        path,
        image.radiance,
        half_a=image.half_a,
        half_b=image.half_b,
        variance=image.variance,
        layers=image.layers,
        metadata=dict(metadata),
    )
