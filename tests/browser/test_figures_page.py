"""The page of the paper's figures in a real browser: order, both engines, numbers, keys, and the way in and out."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.browser.conftest import Watched
from tests.report.synthetic import write_paper_run
from vitrail.report.build import build_report

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def paper(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A report of a run with the figures 8, 5, 7, 6 and 1 in that order, and a scene that is none."""
    folder = tmp_path_factory.mktemp("paper")
    write_paper_run(folder)
    build_report(folder)
    return folder


def test_the_figures_stand_in_the_papers_order_with_both_engines(watched: Watched, paper: Path) -> None:
    page = watched.page
    page.goto((paper / "index.html").as_uri())
    page.keyboard.press("p")
    page.wait_for_url("**/figures.html*")
    headings = [text.split("\n")[0] for text in page.locator(".plate h2").all_inner_texts()]
    assert [heading.split(" ", 1)[0] for heading in headings] == ["Figure", "Figures", "Figure"]
    assert page.locator("#figure-1 img").count() == 2
    alt = [image.get_attribute("alt") for image in page.locator("#figures-5-6-7 img").all()]
    assert [str(text).split(": ")[1][0] for text in alt] == list("567567"), "a row an engine, a column a figure"
    assert all("Tracer" in str(text) for text in alt[:3]) and all("POV-Ray" in str(text) for text in alt[3:])
    broken = "[...document.images].filter((image) => !image.complete || !image.naturalWidth).map((image) => image.src)"
    page.evaluate("document.images.forEach?.((image) => image.scrollIntoView())")
    assert page.evaluate(broken) == []
    assert "distribution 0.032" in page.locator("#figure-8").inner_text()
    watched.check()


def test_a_figure_states_what_the_engines_agree_on(watched: Watched, paper: Path) -> None:
    page = watched.page
    page.goto((paper / "figures.html").as_uri())
    rows = page.locator("#figure-1 tbody tr")
    assert rows.count() == 2, "one number a metric between the engines, and none against the closed form"
    assert "1.3" in rows.nth(0).inner_text() and "deviates" in rows.nth(0).inner_text()
    rows.nth(0).get_by_role("link", name="ring").click()
    page.wait_for_url("**/figure_1/index.html*")
    watched.check()


def test_keys_walk_from_figure_to_figure(watched: Watched, paper: Path) -> None:
    page = watched.page
    page.goto((paper / "figures.html").as_uri())
    focused = "document.activeElement.id"
    for key, plate in (
        ("j", "figure-1"),
        ("j", "figures-5-6-7"),
        ("j", "figure-8"),
        ("j", "figure-8"),
        ("k", "figures-5-6-7"),
    ):
        page.keyboard.press(key)
        assert page.evaluate(focused) == plate
    page.keyboard.press("u")
    page.wait_for_url("**/index.html*")
    page.set_viewport_size({"width": 400, "height": 800})
    page.goto((paper / "figures.html").as_uri())
    assert page.evaluate("document.documentElement.scrollWidth") <= 400
    watched.check()


def test_a_run_without_figures_has_no_such_page(watched: Watched, report: Path) -> None:
    assert not (report / "figures.html").exists()
    watched.page.goto((report / "index.html").as_uri())
    assert watched.page.get_by_role("link", name="The paper's figures").count() == 0
    watched.page.keyboard.press("p")
    watched.check()
