"""The trade-off as one page that opens from disk: a sentence, error against CPU seconds, fronts, tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from vitrail.base.whole_file import write_whole
from vitrail.report.charts import LogAxis, Tick, log_axis
from vitrail.report.environment import chart
from vitrail.report.study_page import write_study_page
from vitrail.study.tradeoff.predictions import ScoredPrediction
from vitrail.study.tradeoff.records import PhenomenonPrices, Tradeoff, TriedSetting

WIDTH, HEIGHT = 720.0, 380.0
LEAST_ERROR = 1e-5
"""Errors below are drawn at the foot of the chart: single precision and half floats end there."""

MARKS = {"light_bins": "bins", "beams": "beams"}
"""How the points of a solver are drawn where it is not the usual one."""


@dataclass(frozen=True)
class SettingMark:
    """One setting: its place, the ends of both its intervals, and the kind of its mark."""

    x: float
    y: float
    left: float
    right: float
    top: float
    bottom: float
    kind: str
    setting: TriedSetting


@dataclass(frozen=True)
class EngineMarks:
    """The settings of one engine from cheap to expensive, and the line through its front."""

    points: list[SettingMark]
    front: str


@dataclass(frozen=True)
class PriceChart:
    """Error against cost on ``width`` by ``height`` units; ``own_error`` is where a reference's own error lies."""

    width: float
    height: float
    across: list[Tick]
    up: list[Tick]
    targets: list[Tick]
    engines: dict[str, EngineMarks]
    own_error: float | None


def write_tradeoff_page(out: Path, found: Tradeoff, predictions: Sequence[ScoredPrediction] = ()) -> Path:
    """Write ``index.html`` and a picture a phenomenon into ``out``; returns the page.

    Numbers come from ``found`` (tradeoff.json) and ``predictions`` (predictions.json) alone.
    """
    views = {phenomenon: _view(entry) for phenomenon, entry in found.phenomena.items()}
    for phenomenon, view in views.items():
        write_whole(out / f"{phenomenon}.svg", chart("front.svg", view=view, title=found.title, phenomenon=phenomenon))
    return write_study_page(out, chart("tradeoff.html", found=found, views=views, predictions=predictions))


def write_prices_page(out: Path, studies: Mapping[str, Tradeoff]) -> Path:
    """One page over several studies, each in its folder below ``out``: their sentences and pictures."""
    return write_study_page(out, chart("prices.html", studies=studies))


def _view(entry: PhenomenonPrices) -> PriceChart:
    """Where everything of one chart is drawn."""
    settings = [each for front in entry.engines.values() for each in front.settings]
    across = log_axis([each.cost_s.value for each in settings], WIDTH)
    errors = [max(each.error.value, LEAST_ERROR) for each in settings]
    targets = [row.target for row in entry.equal_error]
    up = log_axis([*errors, *(target for target in targets if target > min(errors) / 3)], HEIGHT, falling=True)
    own = entry.reference_error
    return PriceChart(
        width=WIDTH,
        height=HEIGHT,
        across=across.ticks(1.0, " s"),
        up=up.ticks(100.0, " %"),
        targets=[Tick(t, up.place(t), f"{100 * t:g} %") for t in targets if up.low < t < up.high],
        engines={engine: _marks(front.settings, across, up) for engine, front in entry.by_engine},
        own_error=up.place(own) if own is not None and up.low < own < up.high else None,
    )


def _marks(settings: Sequence[TriedSetting], across: LogAxis, up: LogAxis) -> EngineMarks:
    points = [
        SettingMark(
            x=across.place(each.cost_s.value),
            y=up.place(each.error.value),
            left=across.place(each.cost_s.low),
            right=across.place(each.cost_s.high),
            top=up.place(each.error.high),
            bottom=up.place(each.error.low),
            kind=MARKS.get(str(each.knobs.get("solver")), "usual"),
            setting=each,
        )
        for each in sorted(settings, key=lambda each: each.cost_s.value)
    ]
    front = " ".join(f"{point.x},{point.y}" for point in points if point.setting.on_front)
    return EngineMarks(points, front)
