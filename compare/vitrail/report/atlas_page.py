"""The stability atlas as one page that opens from disk: a bar an engine and axis, readings, scenes of first failure."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from vitrail.report.study_page import environment, write_study_page

WIDTH = 640
"""Length of an axis in the picture, in its own units."""


def write_atlas_page(out: Path, atlas: dict[str, Any]) -> Path:
    """Write ``index.html`` and its style into ``out``; returns the page. Numbers come from ``atlas`` alone."""
    axes = [record | {"bars": _bars(record), "ticks": _ticks(record)} for record in atlas["axes"]]
    return write_study_page(out, environment().get_template("atlas.html").render(axes=axes, width=WIDTH))


def _bars(record: dict[str, Any]) -> list[dict[str, Any]]:
    """For each engine: how far it holds on the axis (0 to WIDTH), and its readings as points with digits kept."""
    bars = []
    for engine, found in record["engines"].items():
        if found.get("failure"):
            bars.append({"engine": engine, "failure": found["failure"], "length": 0.0, "points": []})
            continue
        holding = found["last_holding"]
        points = [
            {"x": _place(record, reading["value"]), "holds": reading["holds"], "reading": reading}
            for reading in found["readings"]
        ]
        length = 0.0 if holding is None else _place(record, holding)
        bars.append({"engine": engine, "length": length, "points": points, "found": found})
    return bars


def _ticks(record: dict[str, Any]) -> list[dict[str, Any]]:
    """A tick at every second power of ten between the ends of the axis."""
    low, high = sorted((math.log10(record["first"]), math.log10(record["last"])))
    step = max(1, math.ceil((high - low) / 8))
    exponents = [e for e in range(math.ceil(low - 1e-9), math.floor(high + 1e-9) + 1) if e % step == 0]
    return [{"x": _place(record, 10.0**exponent), "exponent": exponent} for exponent in exponents]


def _place(record: dict[str, Any], value: float) -> float:
    first, last = math.log10(record["first"]), math.log10(record["last"])
    return WIDTH * (math.log10(value) - first) / (last - first)
