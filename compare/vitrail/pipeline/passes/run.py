"""Passes one after the other until enough of them are made: image, run record and checkpoint in their places."""

from __future__ import annotations

import json
import math
import os
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from vitrail.base.canonical_json import canonical_json
from vitrail.base.progress import Progress, silent
from vitrail.engines.base import Engine, Rendering
from vitrail.engines.engine_build import build_of
from vitrail.images.exr import ImageLayers, read_image, write_image
from vitrail.judge.half_error import HalfError, Observer
from vitrail.judge.references import SceneTruth
from vitrail.judge.thresholds import Thresholds
from vitrail.pipeline.content_keys import tracer_key
from vitrail.pipeline.passes.checkpoint import (
    Checkpoint,
    Identity,
    checkpoint_path,
    read_checkpoint,
    write_checkpoint,
)
from vitrail.pipeline.passes.interrupt import Interrupt
from vitrail.pipeline.passes.record import cpu_seconds, with_record
from vitrail.pipeline.passes.schedule import blur_radius_m, gather_radii_m, lowered_pass
from vitrail.pipeline.passes.stop import Reason, Wish, is_spent, next_look, passes_wanted
from vitrail.scene.model import Scene

LAW = "r^2 (i + 1) = r^2 (i) (i + 2/3) / (i + 1)"


@dataclass(frozen=True)
class PassesJob:
    """One image to be made from passes. ``lowered`` is the tracer's input for the first of them; ``truth`` and
    ``thresholds`` say which numbers of an observation count, and relative to what."""

    scene: Scene
    lowered: dict[str, Any]
    out: Path
    truth: SceneTruth
    thresholds: Thresholds
    engine: Engine
    threads: int = 0

    @property
    def first_radius_m(self) -> float:
        """Gather radius of the first pass, the largest."""
        return float(self.lowered["settings"]["gather_radius_m"])

    @cached_property
    def observer(self) -> Observer:
        return Observer(self.scene, self.truth, self.thresholds, self.first_radius_m)

    @property
    def identity(self) -> Identity:
        build = build_of(self.engine)
        settings = self.lowered["settings"]
        return Identity(tracer_key(build, self.lowered), self.lowered["scene_hash"], settings, build)


@dataclass(frozen=True)
class Look:
    """What the error was after so many passes, and after how many it should be small enough; None: never."""

    passes: int
    cpu_s: float
    errors: tuple[HalfError, ...]
    wanted: int | None


@dataclass(frozen=True)
class Finished:
    """Why it ended, and the run record; ``record`` is None where not one pass was finished, and nothing is written."""

    reason: Reason
    record: dict[str, Any] | None
    errors: tuple[HalfError, ...] = ()


def run_passes(
    job: PassesJob,
    wish: Wish,
    interrupt: Interrupt,
    *,
    resume: bool = False,
    progress: Progress = silent,
    on_look: Callable[[Look], None] = lambda look: None,
) -> Finished:
    """Make passes until ``wish`` is fulfilled or somebody interrupts; write image, record and checkpoint.

    Raises CheckpointError for a checkpoint that cannot be resumed, EngineFailure, and ThresholdError.
    """
    identity, place = job.identity, checkpoint_path(job.out)
    state = read_checkpoint(place, identity) if resume else Checkpoint(identity)
    targets = tuple(map(str, wish.targets))
    if state.targets != targets:
        state = replace(state, targets=targets, next_look=max(state.sums.count, 1))
    reason = None
    while reason is None:
        count = state.sums.count
        if targets and count >= state.next_look:
            state, met = _looked(job, wish, state, on_look)
            reason = Reason.TARGET_ERROR if met else None
        reason = reason or is_spent(wish, state.cpu_s) or (Reason.INTERRUPTED if interrupt.asked else None)
        if reason is None:
            further = _with_pass(job, state, interrupt, progress)
            if further is None:
                reason = Reason.INTERRUPTED
            else:
                state = further
                write_checkpoint(place, state)
    if not state.sums.count:
        return Finished(reason, None)
    write_checkpoint(place, state)
    return _written(job, state, reason)


def _with_pass(job: PassesJob, state: Checkpoint, interrupt: Interrupt, progress: Progress) -> Checkpoint | None:
    """One more pass; None when it was abandoned, and what it had is dropped."""
    number = state.sums.count + 1
    lowered = lowered_pass(job.lowered, number)
    with tempfile.TemporaryDirectory(dir=job.out.parent, prefix=f".{job.out.stem}-") as work:
        made = _rendered(
            job, lowered, Path(work), interrupt, lambda phase, *rest: progress(f"pass {number} {phase}", *rest)
        )
        if made is None or made.interrupted:
            return None
        image = read_image(made.image_path)
    assert image.half_a is not None and image.half_b is not None
    sums = state.sums.with_pass(image)
    moves = job.observer.moves(sums.mean(), (image.half_a - image.half_b) / 2)
    return replace(
        state,
        sums=sums,
        scatter=state.scatter.with_moves(moves),
        record=with_record(state.record, made.record, number - 1),
        metadata=state.metadata or {key: value for key, value in image.metadata.items() if key.startswith("vitrail:")},
        noise=(*state.noise, sums.noise()),
        cpu_s=(*state.cpu_s, cpu_seconds(made.record)),
    )


def _rendered(
    job: PassesJob, lowered: dict[str, Any], work: Path, interrupt: Interrupt, progress: Progress
) -> Rendering | None:
    try:
        with interrupt.abandonable():
            return job.engine.render(lowered, work, threads=job.threads, progress=progress)
    except KeyboardInterrupt:
        return None


def _looked(job: PassesJob, wish: Wish, state: Checkpoint, on_look: Callable[[Look], None]) -> tuple[Checkpoint, bool]:
    """Measure the errors of the targets; whether they are met, and when to look again."""
    passes = state.sums.count
    errors = _errors(job, state, frozenset(target.phenomenon for target in wish.targets))
    wanted = passes_wanted(wish.targets, errors, passes)
    on_look(Look(passes, math.fsum(state.cpu_s), errors, wanted))
    met = wanted is not None and wanted <= passes
    return replace(state, next_look=passes if met else next_look(wanted, passes)), met


def _errors(job: PassesJob, state: Checkpoint, phenomena: frozenset[str] | None = None) -> tuple[HalfError, ...]:
    blur_radius_m = _blur_radius_m(job, state)
    return job.observer.errors(state.sums.mean(), state.scatter, blur_radius_m=blur_radius_m, phenomena=phenomena)


def _blur_radius_m(job: PassesJob, state: Checkpoint) -> float:
    """The root of the mean square gather radius; 0 where what the camera sees is counted in pixels."""
    if state.record["settings"]["solver"] != "photon_map":
        return 0.0
    return blur_radius_m(job.first_radius_m, state.sums.count)


def _written(job: PassesJob, state: Checkpoint, reason: Reason) -> Finished:
    """Image and record, each whole or not at all."""
    errors = _errors(job, state)
    about = _about(job, state, errors)
    record = {
        **state.record,
        "interrupted": reason is Reason.INTERRUPTED,
        "passes": {
            **about,
            "stopped_by": reason.value,
            "noise": list(state.noise),
            "cpu_s": list(state.cpu_s),
            "gather_radius_m": gather_radii_m(job.first_radius_m, state.sums.count),
        },
    }
    metadata = {**state.metadata, "vitrail:passes": json.dumps(about)}
    with tempfile.TemporaryDirectory(dir=job.out.parent, prefix=f".{job.out.stem}-") as work:
        image, text = Path(work) / "image.exr", Path(work) / "record.json"
        _write_image(image, state.sums.mean(), metadata)
        text.write_text(canonical_json(record), encoding="utf-8")
        os.replace(text, job.out.with_suffix(".run.json"))
        os.replace(image, job.out)
    return Finished(reason, record, errors)


def _about(job: PassesJob, state: Checkpoint, errors: tuple[HalfError, ...]) -> dict[str, Any]:
    """What an image says of its passes: the same for the same passes, however many sittings and seconds they took."""
    count = state.sums.count
    return {
        "count": count,
        "radius_law": LAW,
        "first_radius_m": job.first_radius_m,
        "last_radius_m": gather_radii_m(job.first_radius_m, count)[-1],
        "blur_radius_m": _blur_radius_m(job, state),
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
