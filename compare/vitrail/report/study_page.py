"""A folder of a study that opens from disk: its page with the styles and scripts beside it."""

from __future__ import annotations

from pathlib import Path

from vitrail.base.whole_file import write_whole

STATIC = Path(__file__).parent / "static"


def write_study_page(out: Path, html: str) -> Path:
    """``index.html`` with the styles and scripts it names beside it; each file appears whole."""
    for name in ("style.css", "chart.css", "study.css", "state.js", "theme.js", "study.js"):
        write_whole(out / "report" / name, (STATIC / name).read_bytes())
    write_whole(out / "index.html", html)
    return out / "index.html"
