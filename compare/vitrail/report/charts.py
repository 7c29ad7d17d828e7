"""Where marks of a logarithmic chart go: limits, ticks, places. Plain numbers for a template."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

MOST_LABELS = 9
"""Ticks with a number along one axis; more run into each other."""


@dataclass(frozen=True)
class Tick:
    """A line of the grid at ``place``; ``label`` is empty where a number would not fit."""

    value: float
    place: float
    label: str


@dataclass(frozen=True)
class LogAxis:
    """From ``low`` to ``high`` (values, not exponents) on ``length`` units of the picture; ``falling`` runs upwards."""

    low: float
    high: float
    length: float
    falling: bool = False

    def place(self, value: float) -> float:
        """Where a value is drawn; what is outside the axis at its nearer end."""
        share = math.log(max(value, self.low) / self.low) / math.log(self.high / self.low)
        share = min(share, 1.0)
        return round(self.length * ((1 - share) if self.falling else share), 2)

    def ticks(self, scale: float = 1.0, unit: str = "") -> list[Tick]:
        """Grid lines at 1, 2 and 5 of every decade, labelled as far as there is room, in ``scale`` times the value."""
        first, last = math.floor(math.log10(self.low)), math.ceil(math.log10(self.high))
        for steps in ((1, 2, 5), (1, 3), (1,)):
            labelled = [s * 10.0**e for e in range(first, last + 1) for s in steps]
            if sum(self.low <= value <= self.high for value in labelled) <= MOST_LABELS:
                break
        stride = 1 + sum(self.low <= 10.0**e <= self.high for e in range(first, last + 1)) // (MOST_LABELS + 1)
        kept = {value for value in labelled if len(steps) > 1 or round(math.log10(value)) % stride == 0}
        places = sorted(kept | {10.0**e for e in range(first, last + 1)})
        return [
            Tick(value, self.place(value), _plain(value * scale) + unit if value in kept else "")
            for value in places
            if self.low * 0.999 <= value <= self.high * 1.001
        ]


def log_axis(values: Iterable[float], length: float, *, falling: bool = False, margin: float = 1.25) -> LogAxis:
    """An axis that holds all positive ``values`` with a factor ``margin`` at either end, and at least half a decade."""
    positive = [value for value in values if value > 0 and math.isfinite(value)]
    if not positive:
        return LogAxis(0.1, 10.0, length, falling)
    low, high = min(positive) / margin, max(positive) * margin
    if high / low < math.sqrt(10):
        middle = math.sqrt(high * low)
        low, high = middle / 10**0.25, middle * 10**0.25
    return LogAxis(low, high, length, falling)


def _plain(value: float) -> str:
    """A tick's number: 0.02, 5, 2 000; powers of ten where zeros would be counted."""
    if 1e-4 < value < 1e5:
        return f"{value:,.10f}".rstrip("0").rstrip(".").replace(",", "\u2009")
    mantissa, exponent = f"{value:.0e}".split("e")
    raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"10{raised}" if mantissa == "1" else f"{mantissa}·10{raised}"
