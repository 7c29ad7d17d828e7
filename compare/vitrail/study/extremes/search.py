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


Between = Callable[[float, float], float | None]
"""The value to try between a holding and a failing one; None where they are as close as needed."""


def geometric(holding: float, failing: float) -> float | None:
    """Halfway in the logarithm, until both are within ``SHARPNESS``."""
    if max(failing / holding, holding / failing) <= SHARPNESS:
        return None
    return math.copysign(math.sqrt(holding * failing), failing)


def whole(holding: float, failing: float) -> float | None:
    """Halfway over whole numbers, until they are neighbours."""
    return float(math.floor((holding + failing) / 2)) if abs(failing - holding) > 1 else None


def binary(holding: float, failing: float) -> float | None:
    """Halfway over powers of two times the holding value, until the failing one is the next."""
    steps = round(math.log2(failing / holding))
    return math.ldexp(holding, steps // 2 if steps > 0 else -(-steps // 2)) if abs(steps) > 1 else None


def find_limit(values: list[float], probe: Callable[[float], Reading], between: Between = geometric) -> Range:
    """Try ``values`` in order until one fails, then bisect."""
    readings: list[Reading] = []
    holding: float | None = None
    for value in values:
        reading = probe(value)
        readings.append(reading)
        if not reading.holds:
            return _bisect(readings, probe, holding, value, between)
        holding = value
    return Range(tuple(readings), holding, None)


def _bisect(
    readings: list[Reading],
    probe: Callable[[float], Reading],
    holding: float | None,
    failing: float,
    between: Between,
) -> Range:
    """Halve the distance between a holding and a failing value."""
    while holding is not None and (middle := between(holding, failing)) is not None:
        reading = probe(middle)
        readings.append(reading)
        if reading.holds:
            holding = middle
        else:
            failing = middle
    return Range(tuple(readings), holding, failing)
