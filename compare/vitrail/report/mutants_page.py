"""The confusion matrix as one page: injected phenomenon against reported phenomenon, and what one number would say."""

from __future__ import annotations

from pathlib import Path

from vitrail.report.environment import chart
from vitrail.report.study_page import write_study_page
from vitrail.study.mutants.records import Mutants


def write_mutants_page(out: Path, found: Mutants) -> Path:
    """Write ``index.html`` into ``out``; returns the page. Numbers come from ``found`` (mutants.json) alone."""
    return write_study_page(out, chart("mutants.html", found=found))
