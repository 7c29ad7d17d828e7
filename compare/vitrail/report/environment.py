"""The templates of all pages and texts: unknown names are errors, and numbers are written in one way."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import jinja2
from markupsafe import Markup

from vitrail.report import figures, page, paper_figures

HERE = Path(__file__).parent


@cache
def pages() -> jinja2.Environment:
    """HTML of a run: what is shown is escaped, and a line that holds a tag alone leaves no line."""
    found = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE / "templates"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found.filters |= {
        "agreement": paper_figures.agreement,
        "bar": figures.interval_bar,
        "box": page.box,
        "by_pair": page.by_pair,
        "confidence": page.confidence,
        "cpu": page.cpu,
        "factor": page.factor,
        "flat": page.flat,
        "headline": page.headline,
        "key": page.verdict_key,
        "lower_first": page.lower_first,
        "number": page.number,
        "percent": page.percent,
        "phenomena": page.scene_phenomena,
        "plot": figures.profile_plot,
        "points": page.points,
        "quantity": page.quantity,
        "row": page.row,
        "setting": page.setting,
        "short": page.short,
        "side": page.side_name,
        "unbroken": page.unbroken,
        "words": page.words,
    }
    found.globals |= {
        "chart_style": Markup((HERE / "static" / "chart.css").read_text(encoding="utf-8")),
        "glyphs": page.GLYPHS,
        "names": page.ENGINE_NAMES,
        "status_words": page.STATUS_WORDS,
    }
    return found


@cache
def charts() -> jinja2.Environment:
    """HTML and SVG of studies: lines stay as the template has them."""
    return pages().overlay(trim_blocks=False, lstrip_blocks=False)


@cache
def texts() -> jinja2.Environment:
    """Markdown: nothing is escaped, and the last line ends."""
    return pages().overlay(autoescape=False, keep_trailing_newline=True)


def text(name: str, **values: object) -> str:
    """One Markdown template with its values."""
    return texts().get_template(name).render(values)


def chart(name: str, **values: object) -> str:
    """One page or picture of a study with its values."""
    return charts().get_template(name).render(values)
