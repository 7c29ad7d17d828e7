"""The stability atlas as one page that opens from disk: a table of limits, the digits kept along every axis, scenes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vitrail.report.charts import LogAxis
from vitrail.report.page import number
from vitrail.report.study_page import environment, write_study_page

WIDTH, HEIGHT = 720.0, 150.0
ALL_DIGITS = 16.0
NAMES = {"tracer": "Tracer", "povray": "POV-Ray"}


def write_atlas_page(out: Path, atlas: dict[str, Any]) -> Path:
    """Write ``index.html`` and its style into ``out``; returns the page. Numbers come from ``atlas`` alone."""
    axes = [record | {"view": _view(record)} for record in atlas["axes"]]
    template = environment().get_template("atlas.html")
    return write_study_page(out, template.render(axes=axes, table=limits(atlas), finding=finding(atlas), names=NAMES))


def finding(atlas: Mapping[str, Any]) -> str:
    """What the atlas found, in one sentence."""
    whole = {engine: 0 for engine in NAMES}
    for record in atlas["axes"]:
        for engine, found in record["engines"].items():
            whole[engine] += found.get("failure") is None and found["first_failing"] is None
    total = len(atlas["axes"])
    return (
        f"Of {total} quantities made extreme, the tracer holds {whole['tracer']} to the last value tried and names the"
        f" reason for the other {total - whole['tracer']}; POV-Ray, without our normalisation, holds {whole['povray']}."
    )


def limits(atlas: Mapping[str, Any]) -> list[dict[str, Any]]:
    """The table of axes by engine: the first failing value, or the last one tried, with unit and digits kept."""
    return [
        {
            "name": record["name"],
            "quantity": record["quantity"],
            "cells": {engine: _cell(record, record["engines"][engine]) for engine in NAMES},
        }
        for record in atlas["axes"]
    ]


def table_lines(atlas: Mapping[str, Any]) -> list[str]:
    """The table as Markdown, line by line, with the scenes of first failures linked below ``scenes/``."""
    lines = ["| quantity | Tracer | POV-Ray |", "|---|---|---|"]
    for row in limits(atlas):
        cells = [
            f"{cell['words']} ([yaml](scenes/{row['name']}-{engine}.yaml), [pov](scenes/{row['name']}-{engine}.pov))"
            if cell["fails"]
            else cell["words"]
            for engine, cell in row["cells"].items()
        ]
        lines.append(f"| {row['quantity']} | " + " | ".join(cells) + " |")
    return lines


def reason_lines(atlas: Mapping[str, Any]) -> list[str]:
    """Why each range ends, as a Markdown list, where the atlas knows."""
    return [
        f"* {NAMES[engine]}, {record['quantity']}: {found['limit']}. Digits kept before: {_digits_kept(found):.0f}."
        for engine in NAMES
        for record in atlas["axes"]
        if not (found := record["engines"][engine]).get("failure")
        and found["first_failing"] is not None
        and found["limit"]
    ]


def _cell(record: Mapping[str, Any], found: Mapping[str, Any]) -> dict[str, Any]:
    unit = "" if record["unit"] == "1" else f" {record['unit']}"
    if found.get("failure"):
        return {"words": f"not measured: {found['failure']}", "fails": False, "digits": None}
    fails = found["first_failing"] is not None
    value = found["first_failing"] if fails else found["last_holding"]
    words = f"fails from {number(value, 3)}{unit}" if fails else f"holds to {number(value, 3)}{unit}"
    return {"words": words, "fails": fails, "digits": _digits_kept(found)}


def _digits_kept(found: Mapping[str, Any]) -> float:
    """The fewest digits that any holding reading kept."""
    return float(min((reading["digits"] for reading in found["readings"] if reading["holds"]), default=0.0))


# --- chart ----------------------------------------------------------------------------------------------------------


def _view(record: Mapping[str, Any]) -> dict[str, Any]:
    """For each engine: the digits kept at every value tried, and where its range ends."""
    first, last = record["first"], record["last"]
    axis = LogAxis(min(first, last), max(first, last), WIDTH)
    # The way into the extreme is drawn from left to right, whichever way the number runs.
    turn = (lambda place: place) if last > first else (lambda place: WIDTH - place)
    unit = "" if record["unit"] == "1" else f" {record['unit']}"
    return {
        "width": WIDTH,
        "height": HEIGHT,
        "ticks": [{"x": turn(tick.place), "label": tick.label + unit} for tick in axis.ticks() if tick.label],
        "digits": [{"y": _height(digits), "digits": digits} for digits in (0, 4, 8, 12, 16)],
        "engines": {
            engine: _line(record["engines"][engine], lambda value: turn(axis.place(value)))
            for engine in NAMES
            if not record["engines"][engine].get("failure")
        },
    }


def _line(found: Mapping[str, Any], place: Any) -> dict[str, Any]:
    points = sorted(
        (
            {"x": place(reading["value"]), "y": _height(reading["digits"]), "reading": reading}
            for reading in found["readings"]
        ),
        key=lambda point: point["x"],
    )
    failing = found["first_failing"]
    holding = [point for point in points if point["reading"]["holds"]]
    return {
        "points": points,
        "line": " ".join(f"{point['x']:.1f},{point['y']:.1f}" for point in holding),
        "until": None if failing is None else round(place(failing), 1),
    }


def _height(digits: float) -> float:
    """Nothing kept at the foot of the chart, all digits of a double at its top."""
    return round(HEIGHT * (1 - min(max(digits, 0.0), ALL_DIGITS) / ALL_DIGITS), 2) if math.isfinite(digits) else HEIGHT
