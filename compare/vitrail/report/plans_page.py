"""What the plan saves, as one page that opens from disk: a table over all scenes, and what each phenomenon is worth."""

from __future__ import annotations

import math
from pathlib import Path

from vitrail.report.environment import chart
from vitrail.report.study_page import write_study_page
from vitrail.study.tradeoff.plan_records import Plans

LEAST_SHARE = 1e-4
"""A contribution of one part in ten thousand has no shade any more; all of the image has the darkest."""


def write_plans_page(out: Path, found: Plans) -> Path:
    """Write ``index.html`` into ``out``; returns the page. Numbers come from ``found`` (plans.json) alone."""
    return write_study_page(out, chart("plans.html", found=found, shade=shade))


def shade(share: float) -> float:
    """0 to 1, by the logarithm of a contribution."""
    if share <= LEAST_SHARE:
        return 0.0
    return round(min(1 - math.log(min(share, 1.0)) / math.log(LEAST_SHARE), 1.0), 3)
