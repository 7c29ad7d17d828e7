"""What the plan saves, as one page that opens from disk: a table over all scenes, and what each phenomenon is worth."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vitrail.base.phenomenon import Phenomenon
from vitrail.report.study_page import environment, write_study_page

LEAST_SHARE = 1e-4
"""A contribution of one part in ten thousand has no shade any more; all of the image has the darkest."""


def write_plans_page(out: Path, found: dict[str, Any]) -> Path:
    """Write ``index.html`` into ``out``; returns the page. Numbers come from ``found`` (plans.json) alone."""
    template = environment().get_template("plans.html")
    rows = [_row(scene) for scene in found["scenes"]]
    return write_study_page(out, template.render(found=found, rows=rows, phenomena=_columns(found["scenes"])))


def _columns(scenes: list[dict[str, Any]]) -> list[str]:
    """Every phenomenon that any scene requires, in the order of the vocabulary."""
    required = {name for scene in scenes for name in scene.get("required", ())}
    return [phenomenon.value for phenomenon in Phenomenon if phenomenon.value in required]


def _row(scene: Mapping[str, Any]) -> dict[str, Any]:
    """One scene, with the shade of every phenomenon's cell; what is less than the runs scatter is no cost."""
    seconds = scene["cpu_s"]
    scatter_s = max((max(runs) - min(runs) for runs in scene["runs_cpu_s"].values()), default=0.0)

    def beyond_scatter(difference_s: float) -> float | None:
        return difference_s if abs(difference_s) > scatter_s else None

    cells = {
        name: {
            "contributes": scene["differences"][name]["relative_l1"],
            "costs_s": beyond_scatter(seconds["plan"] - seconds[name]),
            "shade": _shade(scene["differences"][name]["relative_l1"]),
        }
        for name in scene.get("required", ())
    }
    saved_s = beyond_scatter(seconds["everything"] - seconds["plan"]) if cells else None
    return {"scene": scene, "cells": cells, "saved_s": saved_s}


def _shade(share: float) -> float:
    """0 to 1, by the logarithm of a contribution."""
    if share <= LEAST_SHARE:
        return 0.0
    return round(min(1 - math.log(min(share, 1.0)) / math.log(LEAST_SHARE), 1.0), 3)
