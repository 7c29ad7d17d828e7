"""Inline SVG from numbers that are already in ``results.json``: the bar of one comparison, the plot of one profile."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from vitrail.judge.comparison import Comparison, Profile
from vitrail.report.page import number, quantity, raised, side_name

BAR_WIDTH, BAR_HEIGHT = 220, 26
PLOT_WIDTH, PLOT_HEIGHT = 560, 240
MARGIN_LEFT, MARGIN_RIGHT, MARGIN_TOP, MARGIN_BOTTOM = 58, 14, 26, 40


def interval_bar(comparison: Comparison) -> Markup:
    """The tolerance as a band, the interval of the difference as a line, the difference as a dot, zero as a tick.

    The scale holds both; a difference far outside is drawn at the edge with an arrow head.
    """
    tolerance, interval = comparison.tolerance, comparison.interval
    reach = max(abs(interval.low), abs(interval.high), 1e-300)
    # Keep the band readable: show at most six tolerances, then clip the rest with an arrow.
    span = min(max(tolerance * 1.6, reach * 1.15), tolerance * 6) if tolerance > 0 else reach * 1.15
    middle, half = BAR_WIDTH / 2, BAR_WIDTH / 2 - 6

    def x(value: float) -> float:
        return round(middle + half * max(-1.0, min(1.0, value / span)), 2)

    low, high, dot = x(interval.low), x(interval.high), x(comparison.difference)
    clipped = abs(comparison.difference) > span
    y = BAR_HEIGHT / 2
    label = (
        f"difference {quantity(comparison.difference, comparison.unit)}, interval "
        f"{number(interval.low)} to {number(interval.high)}, tolerance ±{number(tolerance)}"
    )
    parts = [
        f'<svg class="bar {comparison.verdict.value}" viewBox="0 0 {BAR_WIDTH} {BAR_HEIGHT}" role="img" '
        f'aria-label="{label}"><title>{label}</title>',
        f'<rect class="band" x="{x(-tolerance)}" y="4" width="{round(x(tolerance) - x(-tolerance), 2)}" '
        f'height="{BAR_HEIGHT - 8}" rx="2"/>',
        f'<line class="zero" x1="{middle}" x2="{middle}" y1="2" y2="{BAR_HEIGHT - 2}"/>',
        f'<line class="reach" x1="{low}" x2="{max(high, low + 0.01)}" y1="{y}" y2="{y}"/>',
        *(
            f'<line class="reach" x1="{x(end)}" x2="{x(end)}" y1="{y - 4}" y2="{y + 4}"/>'
            for end in (interval.low, interval.high)
            if abs(end) <= span
        ),
    ]
    if clipped:
        sign = 1 if comparison.difference > 0 else -1
        parts.append(f'<path class="dot" d="M{dot + 5 * sign} {y} l{-8 * sign} -5 v10 z"/>')
    else:
        parts.append(f'<circle class="dot" cx="{dot}" cy="{y}" r="3.5"/>')
    return Markup("".join(parts) + "</svg>")


@dataclass(frozen=True)
class Axis:
    """A linear axis: data from ``low`` to ``high`` on pixels from ``start`` to ``end``."""

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


def profile_plot(profile: Profile) -> Markup:
    """Radiance along a patch, one line a side, the standard error as a band around it."""
    across = Axis(profile.positions_m[0], profile.positions_m[-1], MARGIN_LEFT, PLOT_WIDTH - MARGIN_RIGHT)
    low = min(0.0, min(min(curve.values) for curve in profile.curves))
    high = max(max(curve.values) for curve in profile.curves)
    up = Axis(low, high if high > low else low + 1.0, PLOT_HEIGHT - MARGIN_BOTTOM, MARGIN_TOP)
    title = f"Profile along {profile.along}, {profile.channel}"
    parts = [
        f'<svg class="plot" viewBox="0 0 {PLOT_WIDTH} {PLOT_HEIGHT}" role="img" aria-label="{title}">',
        f"<title>{title}</title>",
        *_frame(across, up, profile.unit, profile.along),
    ]
    for curve in profile.curves:
        if curve.standard_error:
            parts.append(_band(across, up, profile.positions_m, curve.values, curve.standard_error, curve.side))
        points = " ".join(f"{across.at(s)},{up.at(v)}" for s, v in zip(profile.positions_m, curve.values, strict=True))
        parts.append(f'<polyline class="curve side-{curve.side}" points="{points}"/>')
    parts.append(_legend([curve.side for curve in profile.curves]))
    return Markup("".join(parts) + "</svg>")


def _frame(across: Axis, up: Axis, unit: str, along: str) -> list[str]:
    """Grid lines with their numbers; positions in millimetres where the patch is small."""
    scale, word = (1e3, "mm") if max(abs(across.low), abs(across.high)) < 0.1 else (1.0, "m")
    parts = []
    for tick in ticks(up.low, up.high, 4):
        y = up.at(tick)
        parts.append(f'<line class="grid" x1="{across.start}" x2="{across.end}" y1="{y}" y2="{y}"/>')
        parts.append(
            f'<text class="tick" x="{across.start - 8}" y="{y + 4}" text-anchor="end">{number(tick, 3)}</text>'
        )
    for tick in ticks(across.low, across.high, 6):
        x = across.at(tick)
        parts.append(f'<line class="grid" x1="{x}" x2="{x}" y1="{up.start}" y2="{up.start + 4}"/>')
        text = number(tick * scale, 3)
        parts.append(f'<text class="tick" x="{x}" y="{up.start + 17}" text-anchor="middle">{text}</text>')
    middle = (across.start + across.end) / 2
    parts.append(
        f'<text class="tick" x="{middle}" y="{PLOT_HEIGHT - 5}" text-anchor="middle">'
        f"position along {along} ({word}); height: {raised(unit)}</text>"
    )
    return parts


def _band(
    across: Axis, up: Axis, positions: Sequence[float], values: Sequence[float], error: Sequence[float], side: str
) -> str:
    """The area between value - error and value + error."""
    above = [f"{across.at(s)},{up.at(v + e)}" for s, v, e in zip(positions, values, error, strict=True)]
    below = [f"{across.at(s)},{up.at(v - e)}" for s, v, e in zip(positions, values, error, strict=True)]
    return f'<polygon class="error side-{side}" points="{" ".join(above + below[::-1])}"/>'


def _legend(sides: Sequence[str]) -> str:
    """The sides' names with a piece of their line, in a row above the plot where no curve goes."""
    parts = []
    for place, side in enumerate(sides):
        x = MARGIN_LEFT + 130 * place
        parts.append(f'<line class="curve side-{side}" x1="{x}" x2="{x + 22}" y1="10" y2="10"/>')
        parts.append(f'<text class="tick" x="{x + 29}" y="14">{side_name(side)}</text>')
    return "".join(parts)
