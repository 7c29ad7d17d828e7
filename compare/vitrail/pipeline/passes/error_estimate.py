"""How well the numbers of an image are known after some passes."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.judge.half_error import HalfError
from vitrail.pipeline.passes.checkpoint import Checkpoint
from vitrail.pipeline.passes.passes_job import PassesJob
from vitrail.pipeline.passes.schedule import blur_radius_m


@dataclass(frozen=True)
class ErrorEstimate:
    """The errors after so many passes, and after how many they should be small enough; ``wanted`` None: never."""

    passes: int
    cpu_s: float
    errors: tuple[HalfError, ...]
    wanted: int | None


def errors_after(work: PassesJob, state: Checkpoint, phenomena: frozenset[str] | None = None) -> tuple[HalfError, ...]:
    """The error of every observed number after the finished passes; ``phenomena`` None measures them all."""
    radius_m = mean_blur_m(work, state)
    return work.observer.errors(state.sums.mean(), state.scatter, blur_radius_m=radius_m, phenomena=phenomena)


def mean_blur_m(work: PassesJob, state: Checkpoint) -> float:
    """The root of the mean square gather radius; 0 where what the camera sees is counted in pixels."""
    if state.record["settings"]["solver"] != "photon_map":
        return 0.0
    return blur_radius_m(work.first_radius_m, state.sums.count)
