"""The published files of studies as records."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from vitrail.base.packed import kind_of
from vitrail.base.record import read_record
from vitrail.study.schemas import RECORDS

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ROOT / "docs" / "studies"
TRADEOFFS = ("ball_lens", "prism_screen", "tinted_pane_seen", "slab_clear")


def published(name: str) -> Any:
    """The record of one file below docs/studies, such as ``atlas/atlas.json``; its name says what it is."""
    return read_record(RECORDS[kind_of(Path(name))], STUDIES / name)


def words(path: Path) -> str:
    """A page with its lines joined, to find sentences in."""
    return " ".join(path.read_text().split())
