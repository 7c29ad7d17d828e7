"""Walk an axis from a harmless value to an absurd one, and bisect to the first value at which the invariant fails."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

SHARPNESS = 1.05
"""The bisection stops when the failing and the holding value are within this factor: finer than any limit is known."""


@dataclass(frozen=True)
class Reading:
    """What an engine made of one value: the measured and the expected number, and the deviation that is allowed."""

    value: float
    measured: float
    expected: float
    tolerance: float
    words: str = ""

    @property
    def deviation(self) -> float:
        """Relative to the expected number, absolute where that is 0; infinite for anything not finite."""
        if not math.isfinite(self.measured):
            return math.inf
        return abs(self.measured - self.expected) / (abs(self.expected) or 1.0)

    @property
    def holds(self) -> bool:
        return self.deviation <= self.tolerance


@dataclass(frozen=True)
class Range:
    """``last_holding`` and ``first_failing`` bracket the limit; ``first_failing`` None means the whole walk held."""

    readings: tuple[Reading, ...]
    last_holding: float | None
    first_failing: float | None


def walk(start: float, factor: float, steps: int) -> list[float]:
    """``start * factor^k`` for k = 0 ... steps."""
    return [start * factor**k for k in range(steps + 1)]


def find_limit(
    values: list[float], probe: Callable[[float], Reading], *, whole: bool = False, sharpness: float = SHARPNESS
) -> Range:
    """Try ``values`` in order until one fails, then bisect (in the logarithm, or over whole numbers)."""
    readings: list[Reading] = []
    holding: float | None = None
    for value in values:
        reading = probe(value)
        readings.append(reading)
        if not reading.holds:
            return _bisect(readings, probe, holding, value, whole, sharpness)
        holding = value
    return Range(tuple(readings), holding, None)


def _bisect(
    readings: list[Reading],
    probe: Callable[[float], Reading],
    holding: float | None,
    failing: float,
    whole: bool,
    sharpness: float,
) -> Range:
    """Halve the logarithmic distance between a holding and a failing value."""
    while holding is not None and not _close(holding, failing, whole, sharpness):
        middle = (
            float(math.floor((holding + failing) / 2))
            if whole
            else math.copysign(math.sqrt(holding * failing), failing)
        )
        reading = probe(middle)
        readings.append(reading)
        if reading.holds:
            holding = middle
        else:
            failing = middle
    return Range(tuple(readings), holding, failing)


def _close(holding: float, failing: float, whole: bool, sharpness: float) -> bool:
    if whole:
        return abs(failing - holding) <= 1
    return max(failing / holding, holding / failing) <= sharpness
