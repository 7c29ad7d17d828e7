"""The confusion matrix as one page: injected phenomenon against reported phenomenon, and what one number would say."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from vitrail.base.phenomenon import Phenomenon
from vitrail.report.study_page import environment, write_study_page


def write_mutants_page(out: Path, found: dict[str, Any]) -> Path:
    """Write ``index.html`` into ``out``; returns the page. Numbers come from ``found`` (mutants.json) alone."""
    template = environment().get_template("mutants.html")
    return write_study_page(out, template.render(found=found, **_matrix(found["mutants"])))


def _matrix(entries: list[dict[str, Any]]) -> dict[str, Any]:
    """Counts by (injected, reported); phenomena without a mutant have no row."""
    injected = [p.value for p in Phenomenon if any(entry["injected"] == p.value for entry in entries)]
    reported = [p.value for p in Phenomenon if any(entry["reported"] == p.value for entry in entries)]
    counts = {
        row: {column: sum(e["injected"] == row and e["reported"] == column for e in entries) for column in reported}
        for row in injected
    }
    missed = {row: sum(e["injected"] == row and e["reported"] is None for e in entries) for row in injected}
    alone = {
        metric: sum(1 for entry in entries if entry["alone"].get(metric, {}).get("caught"))
        for metric in ("ssim", "flip", "relmse")
    }
    return {"rows": injected, "columns": reported, "counts": counts, "missed": missed, "alone": alone}
