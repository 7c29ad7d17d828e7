"""The trade-off as one page that opens from disk: a sentence, error against CPU seconds, fronts, tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from vitrail.report.charts import LogAxis, Tick, log_axis
from vitrail.report.study_page import environment, write_study_page

WIDTH, HEIGHT = 720.0, 380.0
LEAST_ERROR = 1e-5
"""Errors below are drawn at the foot of the chart: single precision and half floats end there."""

MARKS = {"light_bins": "bins", "beams": "beams"}
"""How the points of a solver are drawn where it is not the usual one."""


def write_tradeoff_page(out: Path, found: dict[str, Any], predictions: Sequence[Mapping[str, Any]] = ()) -> Path:
    """Write ``index.html`` and a picture a phenomenon into ``out``; returns the page.

    Numbers come from ``found`` (tradeoff.json) and ``predictions`` (predictions.json) alone.
    """
    views = {name: _view(entry) for name, entry in found["phenomena"].items()}
    environ = environment()
    for name, view in views.items():
        picture = environ.get_template("front.svg").render(view=view, title=found["title"], phenomenon=name)
        (out / f"{name}.svg").write_text(picture, encoding="utf-8")
    html = environ.get_template("tradeoff.html").render(found=found, views=views, predictions=predictions)
    return write_study_page(out, html)


def write_prices_page(out: Path, studies: Mapping[str, dict[str, Any]]) -> Path:
    """One page over several studies, each in its folder below ``out``: their sentences and pictures."""
    return write_study_page(out, environment().get_template("prices.html").render(studies=studies))


def _view(entry: Mapping[str, Any]) -> dict[str, Any]:
    """Where everything of one chart is drawn, and the rows of its tables in reading order."""
    settings = [each for record in entry["engines"].values() for each in record["settings"]]
    across = log_axis([each["cost_s"]["value"] for each in settings], WIDTH)
    errors = [max(each["error"]["value"], LEAST_ERROR) for each in settings]
    targets = [row["target"] for row in entry["equal_error"]]
    up = log_axis([*errors, *(target for target in targets if target > min(errors) / 3)], HEIGHT, falling=True)
    return {
        "width": WIDTH,
        "height": HEIGHT,
        "across": across.ticks(1.0, " s"),
        "up": up.ticks(100.0, " %"),
        "targets": [Tick(t, up.place(t), f"{100 * t:g} %") for t in targets if up.low < t < up.high],
        "engines": {name: _marks(record["settings"], across, up) for name, record in entry["engines"].items()},
        "own_error": _own_error(entry, up),
    }


def _own_error(entry: Mapping[str, Any], up: LogAxis) -> float | None:
    """Where the error of a converged reference lies on the chart, if it is on it."""
    own = entry["reference_error"]
    return up.place(own) if own is not None and up.low < own < up.high else None


def _marks(settings: list[dict[str, Any]], across: LogAxis, up: LogAxis) -> dict[str, Any]:
    points: list[dict[str, Any]] = [
        {
            "x": across.place(each["cost_s"]["value"]),
            "left": across.place(each["cost_s"]["low"] or 0.0),
            "right": across.place(each["cost_s"]["high"] or each["cost_s"]["value"]),
            "y": up.place(each["error"]["value"]),
            "top": up.place(each["error"]["high"]),
            "bottom": up.place(each["error"]["low"]),
            "kind": MARKS.get(each["knobs"].get("solver"), "usual"),
            "setting": each,
        }
        for each in sorted(settings, key=lambda each: each["cost_s"]["value"])
    ]
    front = [point for point in points if point["setting"]["on_front"]]
    return {"points": points, "front": " ".join(f"{point['x']},{point['y']}" for point in front)}
