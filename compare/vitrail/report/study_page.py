"""What the pages of studies share: the template environment, and a folder that opens from disk."""

from __future__ import annotations

from pathlib import Path

import jinja2
from markupsafe import Markup

from vitrail.base.whole_file import write_whole
from vitrail.report.page import number, quantity

HERE = Path(__file__).parent


def environment() -> jinja2.Environment:
    """Templates with strict names: a missing number is an error, never an empty cell."""
    found = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE / "templates"), autoescape=True, undefined=jinja2.StrictUndefined
    )
    found.filters.update(number=number, quantity=quantity)
    found.globals.update(chart_style=Markup((HERE / "static" / "chart.css").read_text(encoding="utf-8")))
    return found


def write_study_page(out: Path, html: str) -> Path:
    """``index.html`` with the styles and scripts it names beside it; each file appears whole."""
    for name in ("style.css", "chart.css", "study.css", "state.js", "theme.js", "study.js"):
        text = (HERE / "static" / name).read_text(encoding="utf-8")
        write_whole(out / "report" / name, text)
    write_whole(out / "index.html", html)
    return out / "index.html"
