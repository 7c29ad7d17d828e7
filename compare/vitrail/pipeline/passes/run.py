"""Passes one after the other until enough of them are made: image, run record and checkpoint in their places."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from vitrail.base.progress import Progress, silent
from vitrail.base.scratch import scratch
from vitrail.engines.base import Rendering
from vitrail.images.exr import read_image
from vitrail.judge.half_error import HalfError
from vitrail.pipeline.passes.checkpoint import Checkpoint, checkpoint_path, read_checkpoint, write_checkpoint
from vitrail.pipeline.passes.error_estimate import ErrorEstimate, errors_after
from vitrail.pipeline.passes.interrupt import Interrupt
from vitrail.pipeline.passes.output import write_output
from vitrail.pipeline.passes.passes_job import PassesJob
from vitrail.pipeline.passes.record import cpu_seconds, with_record
from vitrail.pipeline.passes.schedule import lowered_pass
from vitrail.pipeline.passes.stop import Reason, StopCriteria, is_spent, next_look, passes_wanted


@dataclass(frozen=True)
class Finished:
    """Why it ended, and the run record; ``record`` is None where not one pass was finished, and nothing is written."""

    reason: Reason
    record: dict[str, Any] | None
    errors: tuple[HalfError, ...] = ()


def run_passes(
    work: PassesJob,
    criteria: StopCriteria,
    interrupt: Interrupt,
    *,
    resume: bool = False,
    progress: Progress = silent,
    on_estimate: Callable[[ErrorEstimate], None] = lambda estimate: None,
) -> Finished:
    """Make passes until ``criteria`` are met or somebody interrupts; write image, record and checkpoint.

    Raises CheckpointError for a checkpoint that cannot be resumed, EngineFailure, and ThresholdError.
    """
    identity, place = work.identity, checkpoint_path(work.out)
    state = read_checkpoint(place, identity) if resume else Checkpoint(identity)
    targets = tuple(map(str, criteria.targets))
    if state.targets != targets:
        state = replace(state, targets=targets, next_look=max(state.sums.count, 1))
    reason = None
    while reason is None:
        count = state.sums.count
        if targets and count >= state.next_look:
            state, met = _estimated(work, criteria, state, on_estimate)
            reason = Reason.TARGET_ERROR if met else None
        reason = reason or is_spent(criteria, state.cpu_s) or (Reason.INTERRUPTED if interrupt.asked else None)
        if reason is None:
            further = _with_pass(work, state, interrupt, progress)
            if further is None:
                reason = Reason.INTERRUPTED
            else:
                state = further
                write_checkpoint(place, state)
    if not state.sums.count:
        return Finished(reason, None)
    write_checkpoint(place, state)
    errors = errors_after(work, state)
    return Finished(reason, write_output(work, state, reason, errors), errors)


def _with_pass(work: PassesJob, state: Checkpoint, interrupt: Interrupt, progress: Progress) -> Checkpoint | None:
    """One more pass; None when it was abandoned, and what it had is dropped."""
    number = state.sums.count + 1
    lowered = lowered_pass(work.lowered, number)
    with scratch(f".{work.out.stem}-", work.out.parent) as folder:
        watched: Progress = lambda phase, *rest: progress(f"pass {number} {phase}", *rest)  # noqa: E731
        made = _rendered(work, lowered, folder, interrupt, watched)
        if made is None or made.interrupted:
            return None
        image = read_image(made.image_path)
    assert image.half_a is not None and image.half_b is not None
    sums = state.sums.with_pass(image)
    moves = work.observer.moves(sums.mean(), (image.half_a - image.half_b) / 2)
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
    work: PassesJob, lowered: dict[str, Any], folder: Path, interrupt: Interrupt, progress: Progress
) -> Rendering | None:
    try:
        with interrupt.abandonable():
            return work.engine.render(lowered, folder, threads=work.threads, progress=progress)
    except KeyboardInterrupt:
        return None


def _estimated(
    work: PassesJob, criteria: StopCriteria, state: Checkpoint, on_estimate: Callable[[ErrorEstimate], None]
) -> tuple[Checkpoint, bool]:
    """Measure the errors of the targets: when to measure them again, and whether they are met."""
    passes = state.sums.count
    errors = errors_after(work, state, frozenset(target.phenomenon for target in criteria.targets))
    wanted = passes_wanted(criteria.targets, errors, passes)
    on_estimate(ErrorEstimate(passes, math.fsum(state.cpu_s), errors, wanted))
    met = wanted is not None and wanted <= passes
    return replace(state, next_look=passes if met else next_look(wanted, passes)), met
