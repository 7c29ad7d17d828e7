"""The stability atlas as one page that opens from disk: a table of limits, the digits kept along every axis, scenes."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from vitrail.base.engine_name import EngineName
from vitrail.base.whole_file import write_whole
from vitrail.report.charts import LogAxis
from vitrail.report.environment import chart, text
from vitrail.report.page import number
from vitrail.report.study_page import write_study_page
from vitrail.study.extremes.atlas import STACKS
from vitrail.study.extremes.axis import ENGINES
from vitrail.study.extremes.records import Atlas, AtlasAxis, AtlasReading, EngineRange

WIDTH, HEIGHT = 720.0, 150.0
ALL_DIGITS = 16.0


def write_atlas_page(out: Path, atlas: Atlas) -> Path:
    """Write ``index.html`` and its style into ``out``; returns the page. Numbers come from ``atlas`` alone."""
    views = {axis.name: _view(axis) for axis in atlas.axes}
    html = chart("atlas.html", atlas=atlas, views=views, finding=finding(atlas), limit_words=limit_words)
    return write_study_page(out, html)


def atlas_text(atlas: Atlas) -> str:
    """The page of docs/studies/atlas in Markdown, with the scenes of first failures linked below ``scenes/``.

    Stacks of panes have no link: their scenes are made when they are needed.
    """
    return text("atlas.md", atlas=atlas, limit_words=limit_words, stacks=STACKS)


def write_atlas_text(out: Path, atlas: Atlas) -> None:
    """``README.md`` beside ``atlas.json``."""
    write_whole(out / "README.md", atlas_text(atlas))


def finding(atlas: Atlas) -> str:
    """What the atlas found, in one sentence."""
    return text("atlas_finding.md", atlas=atlas).rstrip("\n")


def limit_words(axis: AtlasAxis, engine: EngineName) -> str:
    """The first failing value, or the last one tried, with its unit."""
    found = axis.engines[engine]
    unit = "" if axis.unit == "1" else f" {axis.unit}"
    if found.failure:
        return f"not measured: {found.failure}"
    if found.fails:
        return f"fails from {number(found.first_failing, 3)}{unit}"
    return f"holds to {number(found.last_holding, 3)}{unit}"


# --- chart ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Mark:
    """A line of the grid with its label, or a reading with its place."""

    place: float
    label: str


@dataclass(frozen=True)
class ReadingMark:
    """A reading with its place on the chart."""

    x: float
    y: float
    reading: AtlasReading


@dataclass(frozen=True)
class DigitsLine:
    """One engine on one chart: its readings, the line through those that hold, and where its range ends."""

    points: list[ReadingMark]
    line: str
    until: float | None


@dataclass(frozen=True)
class DigitsChart:
    """For each engine: the digits kept at every value tried, on ``width`` by ``height`` units."""

    width: float
    height: float
    ticks: list[Mark]
    digits: list[Mark]
    engines: dict[EngineName, DigitsLine]


def _view(axis: AtlasAxis) -> DigitsChart:
    """Where everything of one axis is drawn."""
    across = LogAxis(min(axis.first, axis.last), max(axis.first, axis.last), WIDTH)

    def turned(place: float) -> float:
        """The way into the extreme is drawn from left to right, whichever way the number runs."""
        return place if axis.last > axis.first else WIDTH - place

    unit = "" if axis.unit == "1" else f" {axis.unit}"
    return DigitsChart(
        width=WIDTH,
        height=HEIGHT,
        ticks=[Mark(turned(tick.place), tick.label + unit) for tick in across.ticks() if tick.label],
        digits=[Mark(_height(digits), str(digits)) for digits in (0, 4, 8, 12, 16)],
        engines={
            engine: _line(axis.engines[engine], lambda value: turned(across.place(value)))
            for engine in ENGINES
            if not axis.engines[engine].failure
        },
    )


def _line(found: EngineRange, place: Callable[[float], float]) -> DigitsLine:
    points = sorted(
        (ReadingMark(place(reading.value), _height(reading.digits), reading) for reading in found.readings),
        key=lambda point: point.x,
    )
    return DigitsLine(
        points=points,
        line=" ".join(f"{point.x:.1f},{point.y:.1f}" for point in points if point.reading.holds),
        until=None if found.first_failing is None else round(place(found.first_failing), 1),
    )


def _height(digits: float) -> float:
    """Nothing kept at the foot of the chart, all digits of a double at its top."""
    return round(HEIGHT * (1 - min(max(digits, 0.0), ALL_DIGITS) / ALL_DIGITS), 2) if math.isfinite(digits) else HEIGHT
