"""The page of docs/studies/mutants: what the verdicts catch and by what name, from the stored records alone."""

from __future__ import annotations

from pathlib import Path

from vitrail.base.record import write_record
from vitrail.base.whole_file import write_whole
from vitrail.report.environment import text
from vitrail.study.equal_runs import EqualRuns
from vitrail.study.mutants.records import DetectionLimits, LimitNumber, Mutants

ALONE = {"ssim": "SSIM < 0.95", "flip": "FLIP > 0.05", "relmse": "relMSE > 0.01"}
"""What one number over the picture would have stopped a run at, in words."""


def mutants_text(found: Mutants, limits: DetectionLimits, equal: EqualRuns) -> str:
    """The page in Markdown."""
    return text("mutants.md", found=found, limits=limits, equal=equal, alone=ALONE, off_by=off_by)


def limits_table(limits: DetectionLimits) -> str:
    """The table of the smallest defects in Markdown: lengths in mm, shares in %."""
    return text("limits.md", limits=limits, off_by=off_by)


def off_by(number: LimitNumber) -> str:
    """Difference, noise and tolerance, as lengths or as shares of what should be."""
    size, unit = (1e-3, "mm") if number.unit == "m" and not number.ideal else (abs(number.ideal) / 100, "%")
    off, noise, allowed = (each / size for each in (number.difference, number.half_width, number.tolerance))
    return f"{off:.2g} ± {noise:.2g} {unit}, {allowed:.2g} {unit}"


def write_mutants_text(target: Path, found: Mutants, limits: DetectionLimits, equal: EqualRuns) -> Path:
    """README.md and the three files of data in ``target``; returns the page."""
    write_record(found, target / "mutants.json")
    write_record(limits, target / "limits.json")
    write_record(equal, target / "equal_runs.json")
    page = target / "README.md"
    write_whole(page, mutants_text(found, limits, equal))
    return page
