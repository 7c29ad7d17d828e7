"""The trade-off as one page that opens from disk: error against CPU seconds, fronts, tables, one sentence."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from vitrail.report.charts import LogAxis, log_axis
from vitrail.report.study_page import environment, write_study_page

WIDTH, HEIGHT = 640.0, 340.0


def write_tradeoff_page(out: Path, found: dict[str, Any]) -> Path:
    """Write ``index.html`` into ``out``; returns the page. Numbers come from ``found`` (tradeoff.json) alone."""
    charts = {name: _chart(entry) for name, entry in found["phenomena"].items()}
    template = environment().get_template("tradeoff.html")
    return write_study_page(out, template.render(found=found, charts=charts, width=WIDTH, height=HEIGHT))


def write_plans_page(out: Path, found: dict[str, Any]) -> Path:
    """The same for the plan's table (plans.json)."""
    return write_study_page(out, environment().get_template("plans.html").render(found=found))


def _chart(entry: dict[str, Any]) -> dict[str, Any]:
    settings = [each for record in entry["engines"].values() for each in record["settings"]]
    across = log_axis((each["cost_s"]["value"] for each in settings), WIDTH)
    up = log_axis((each["error"]["value"] for each in settings), HEIGHT, falling=True)
    return {
        "across": across.decades,
        "up": up.decades,
        "engines": {name: _marks(record["settings"], across, up) for name, record in entry["engines"].items()},
    }


def _marks(settings: list[dict[str, Any]], across: LogAxis, up: LogAxis) -> dict[str, Any]:
    points: list[dict[str, Any]] = [
        {
            "x": across.place(each["cost_s"]["value"]),
            "y": up.place(max(each["error"]["value"], 1e-300)),
            "top": up.place(max(each["error"]["high"], 1e-300)),
            "bottom": up.place(max(each["error"]["low"], 1e-300)),
            "setting": each,
        }
        for each in settings
    ]
    front = sorted((point for point in points if point["setting"]["on_front"]), key=lambda point: point["x"])
    return {"points": points, "front": " ".join(f"{point['x']:.1f},{point['y']:.1f}" for point in front)}
