"""Where marks of a log-log chart go: decades, ticks, points with their intervals. Plain numbers for a template."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class LogAxis:
    """Whole decades from ``low`` to ``high`` (exponents of ten) on ``length`` units of the picture."""

    low: int
    high: int
    length: float
    falling: bool = False

    def place(self, value: float) -> float:
        share = (math.log10(value) - self.low) / (self.high - self.low)
        share = min(max(share, 0.0), 1.0)
        return self.length * ((1 - share) if self.falling else share)

    @property
    def decades(self) -> list[tuple[int, float]]:
        return [(exponent, self.place(10.0**exponent)) for exponent in range(self.low, self.high + 1)]


def log_axis(values: Iterable[float], length: float, *, falling: bool = False) -> LogAxis:
    """The decades that hold all positive ``values``; at least one."""
    positive = [value for value in values if value > 0 and math.isfinite(value)]
    if not positive:
        return LogAxis(-1, 1, length, falling)
    low, high = math.floor(math.log10(min(positive))), math.ceil(math.log10(max(positive)))
    return LogAxis(low, max(high, low + 1), length, falling)
