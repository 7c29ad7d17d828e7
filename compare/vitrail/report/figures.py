"""Where everything of two drawings goes: the bar of one comparison, and the plot of one profile.

Numbers come from ``results.json``; ``templates/figures.svg`` draws them. Places are in units of the picture,
y downwards.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from vitrail.judge.comparison import Comparison, Curve, Profile
from vitrail.report.page import number, quantity, raised

BAR_WIDTH, BAR_HEIGHT = 220, 26
PLOT_WIDTH, PLOT_HEIGHT = 560, 240
MARGIN_LEFT, MARGIN_RIGHT, MARGIN_TOP, MARGIN_BOTTOM = 58, 14, 26, 40


@dataclass(frozen=True)
class IntervalBar:
    """The tolerance as a band, the interval of the difference as a line, the difference as a dot, zero as a tick.

    ``clipped`` is the sign of a difference that is drawn at the edge with an arrow head, else 0.
    """

    verdict: str
    label: str
    band: float
    band_width: float
    low: float
    high: float
    ends: list[float]
    dot: float
    clipped: int
    width: int = BAR_WIDTH
    height: int = BAR_HEIGHT
    zero: float = BAR_WIDTH / 2
    middle: float = BAR_HEIGHT / 2


def interval_bar(comparison: Comparison) -> IntervalBar:
    """The scale holds tolerance and interval; a difference far outside is clipped."""
    tolerance, interval, difference = comparison.tolerance, comparison.interval, comparison.difference
    reach = max(abs(interval.low), abs(interval.high), 1e-300)
    # Keep the band readable: show at most six tolerances, then clip the rest with an arrow.
    span = min(max(tolerance * 1.6, reach * 1.15), tolerance * 6) if tolerance > 0 else reach * 1.15
    middle, half = BAR_WIDTH / 2, BAR_WIDTH / 2 - 6

    def x(value: float) -> float:
        return round(middle + half * max(-1.0, min(1.0, value / span)), 2)

    label = (
        f"difference {quantity(difference, comparison.unit)}, interval "
        f"{number(interval.low)} to {number(interval.high)}, tolerance ±{number(tolerance)}"
    )
    low, high = x(interval.low), x(interval.high)
    return IntervalBar(
        verdict=comparison.verdict.value,
        label=label,
        band=x(-tolerance),
        band_width=round(x(tolerance) - x(-tolerance), 2),
        low=low,
        high=max(high, low + 0.01),
        ends=[x(end) for end in (interval.low, interval.high) if abs(end) <= span],
        dot=x(difference),
        clipped=0 if abs(difference) <= span else 1 if difference > 0 else -1,
    )


@dataclass(frozen=True)
class LinearAxis:
    """Data from ``low`` to ``high`` on places from ``start`` to ``end``."""

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        return round(self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start), 2)


def ticks(low: float, high: float, about: int = 5) -> list[float]:
    """Round positions (1, 2 or 5 times a power of ten apart) inside [low, high]."""
    if not high > low:
        return [low]
    raw = (high - low) / about
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= raw * 0.999)
    first = math.ceil(low / step - 1e-9)
    return [index * step for index in range(first, math.floor(high / step + 1e-9) + 1)]


@dataclass(frozen=True)
class PlotTick:
    """A grid line with its number."""

    place: float
    label: str


@dataclass(frozen=True)
class DrawnCurve:
    """One side's line, the ``band`` of its standard error (empty without one), and where its ``key`` begins."""

    side: str
    line: str
    band: str
    key: int


@dataclass(frozen=True)
class ProfilePlot:
    """Radiance along a patch, one line a side, in a frame from ``left`` to ``right`` that stands on ``foot``."""

    title: str
    along: str
    unit: str
    metres: str
    up: list[PlotTick]
    across: list[PlotTick]
    curves: list[DrawnCurve]
    left: float
    right: float
    foot: float
    width: int = PLOT_WIDTH
    height: int = PLOT_HEIGHT


def profile_plot(profile: Profile) -> ProfilePlot:
    """Every side's curve with its standard error as a band; positions in millimetres where the patch is small."""
    across = LinearAxis(profile.positions_m[0], profile.positions_m[-1], MARGIN_LEFT, PLOT_WIDTH - MARGIN_RIGHT)
    low = min(0.0, min(min(curve.values) for curve in profile.curves))
    high = max(max(curve.values) for curve in profile.curves)
    up = LinearAxis(low, high if high > low else low + 1.0, PLOT_HEIGHT - MARGIN_BOTTOM, MARGIN_TOP)
    scale, metres = (1e3, "mm") if max(abs(across.low), abs(across.high)) < 0.1 else (1.0, "m")
    return ProfilePlot(
        title=f"Profile along {profile.along}, {profile.channel}",
        along=profile.along,
        unit=raised(profile.unit),
        metres=metres,
        up=[PlotTick(up.at(tick), number(tick, 3)) for tick in ticks(up.low, up.high, 4)],
        across=[PlotTick(across.at(tick), number(tick * scale, 3)) for tick in ticks(across.low, across.high, 6)],
        curves=[_curve(curve, profile.positions_m, across, up, place) for place, curve in enumerate(profile.curves)],
        left=across.start,
        right=across.end,
        foot=up.start,
    )


def _curve(curve: Curve, positions_m: Sequence[float], across: LinearAxis, up: LinearAxis, place: int) -> DrawnCurve:
    """The line, the area between value - error and value + error, and the name in a row above the plot."""

    def points(heights: Sequence[float]) -> list[str]:
        return [f"{across.at(s)},{up.at(height)}" for s, height in zip(positions_m, heights, strict=True)]

    band: list[str] = []
    if curve.standard_error:
        error = list(zip(curve.values, curve.standard_error, strict=True))
        band = points([v + e for v, e in error]) + points([v - e for v, e in error])[::-1]
    return DrawnCurve(curve.side, " ".join(points(curve.values)), " ".join(band), MARGIN_LEFT + 130 * place)
