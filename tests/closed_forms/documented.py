"""docs/closed-forms.md as data: each case, the rays that show it, and the tests and scenes that show it by light."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "closed-forms.md"


@dataclass(frozen=True)
class Row:
    """One line of the table."""

    case: str
    ray: str | None
    """A function of ``test_single_rays``, or None where no single ray is asked."""
    ray_error: float
    light: tuple[str, ...]
    """C++ tests as ``Suite.Name``, and scenes of ``references/analytic.yaml`` as ``name.yaml``."""


@cache
def rows() -> tuple[Row, ...]:
    """Every line of the table."""
    found = []
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("| ") or len(cells) != 5 or cells[0] in ("case", "---"):
            continue
        ray = re.fullmatch(r"`(\w+)`, ([0-9.e-]+)", cells[3])
        names = tuple(re.findall(r"`([^`]+)`", cells[4]))
        found.append(Row(cells[0], ray.group(1) if ray else None, float(ray.group(2)) if ray else 0.0, names))
    return tuple(found)


def reached(name: str) -> float:
    """The error that the page says this function of ``test_single_rays`` reaches."""
    (row,) = (row for row in rows() if row.ray == name)
    return row.ray_error
