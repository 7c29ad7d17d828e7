"""When to stop: after so many passes, when the next would not fit into the budget, when the error is small enough."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from vitrail.judge.half_error import HalfError

LEAST_STEP = 1.25
"""Passes at the next look over those at this one; a target is overshot by so much at most."""


class Reason(StrEnum):
    """Why no further pass was made."""

    PASSES = "passes"
    BUDGET = "budget"
    TARGET_ERROR = "target_error"
    INTERRUPTED = "interrupted"


@dataclass(frozen=True)
class Target:
    """``caustic=0.01``, or ``caustic.r50=0.01`` for one metric or family of the phenomenon."""

    phenomenon: str
    metric: str
    error: float

    def __str__(self) -> str:
        return f"{self.phenomenon}{'.' * bool(self.metric)}{self.metric}={self.error:g}"

    def largest(self, errors: Sequence[HalfError]) -> HalfError | None:
        """The number of this target that is known worst; None where nothing of it could be measured."""
        return max(self._own(errors), key=lambda each: each.error, default=None)

    def largest_of_pixels(self, errors: Sequence[HalfError]) -> HalfError | None:
        """The number of this target that pixels blur most."""
        return max(self._own(errors), key=lambda each: each.pixel_error, default=None)

    def _own(self, errors: Sequence[HalfError]) -> list[HalfError]:
        return [each for each in errors if each.phenomenon == self.phenomenon and self._means(each)]

    def _means(self, number: HalfError) -> bool:
        return self.metric in (number.metric, number.metric.split(".")[0]) if self.metric else number.meant


@dataclass(frozen=True)
class StopCriteria:
    """What ends the passes; whichever comes first. ``budget_s`` are CPU seconds of the engine over all sittings."""

    passes: int | None = None
    budget_s: float | None = None
    targets: tuple[Target, ...] = ()


def is_spent(criteria: StopCriteria, cpu_s: Sequence[float]) -> Reason | None:
    """Whether passes that took ``cpu_s`` leave none to make. One pass is always made: no image is no answer."""
    if criteria.passes is not None and len(cpu_s) >= criteria.passes:
        return Reason.PASSES
    if criteria.budget_s is not None and cpu_s and math.fsum(cpu_s) + next_price_s(cpu_s) > criteria.budget_s:
        return Reason.BUDGET
    return None


def next_price_s(cpu_s: Sequence[float]) -> float:
    """What the next pass will cost: as the mean pass so far; they differ by the radius and by what else runs here."""
    return math.fsum(cpu_s) / len(cpu_s)


def passes_wanted(targets: Sequence[Target], errors: Sequence[HalfError], passes: int) -> int | None:
    """Passes after which all targets should be met, if errors fall as the root of the passes; ``passes`` or fewer when
    they are met. None where a target cannot be measured at all."""
    worst = [target.largest(errors) for target in targets]
    if any(each is None or not math.isfinite(each.error) for each in worst):
        return None
    excess = max(each.error / target.error for each, target in zip(worst, targets, strict=True) if each is not None)
    return math.ceil(passes * excess**2)


def next_look(wanted: int | None, passes: int) -> int:
    """When to measure the error again: where it should be small enough, after a quarter more passes at the earliest and
    twice the passes at the latest.

    It follows from images alone, so the same passes always stop at the same number; and there are three looks an octave
    at most, because each is a test that may stop too early by chance.
    """
    soonest = math.ceil(LEAST_STEP * passes)
    return 2 * passes if wanted is None else min(max(wanted, soonest), 2 * passes)
