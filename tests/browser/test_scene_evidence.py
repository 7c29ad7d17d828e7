"""Below the viewer: profiles with every side, the line that makes it again, the certificate, the provenance."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.browser.conftest import Watched
from tests.browser.test_scene_page import open_scene, shown_radiance
from tests.report.synthetic import WIDTH

pytestmark = pytest.mark.browser


def test_a_profile_has_both_engines_and_the_truth(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    plot = page.locator("#observe-ring svg.plot")
    assert plot.locator("polyline.curve").count() == 3
    points = {
        side: [tuple(map(float, pair.split(","))) for pair in str(curve.get_attribute("points")).split()]
        for side in ("tracer", "povray", "truth")
        for curve in [plot.locator(f"polyline.curve.side-{side}")]
    }
    # The tracer's light is 1.3 times the others', and up is less in a picture's coordinates.
    tops = {side: min(y for _, y in line) for side, line in points.items()}
    assert tops["tracer"] < tops["povray"] - 20
    assert tops["povray"] == pytest.approx(tops["truth"], abs=1)
    assert plot.locator(".error").count() == 1, "the standard error of the side that has one is drawn"
    assert "W sr⁻¹ m⁻²" in str(plot.text_content())
    watched.check()


def test_the_line_that_makes_it_again_is_copied(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    line = page.locator(".copy code").inner_text()
    assert line == "vitrail compare scenes/apart.yaml --out out --quality draft --seed 1"
    page.get_by_role("button", name="Copy").click()
    told = page.locator(".copy button")
    told.filter(has_text="ed").wait_for()
    # A page from disk may be refused the clipboard; then the line is selected, and one key copies it.
    if told.inner_text() == "Selected":
        assert page.evaluate("getSelection().toString().trim()") == line
    watched.check()


def test_certificate_plan_and_provenance_are_on_the_page(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    certificate = page.locator("table.certificate tbody tr").inner_text()
    assert "sun" in certificate and "half-float output" in certificate and "0.0005" in certificate
    assert "no material disperses" in page.locator("table.plan").inner_text()
    page.get_by_text("Settings, seeds and run records").click()
    provenance = page.locator("section", has=page.get_by_role("heading", name="Cost and provenance"))
    text = provenance.inner_text()
    assert "3.7.0.10" in text and "0123456789abcdef" in text and "ledger.closure" in text
    assert provenance.get_by_role("link", name="apart/tracer.exr").is_visible()
    watched.check()


def test_a_narrow_screen_shows_one_image_above_the_other(watched: Watched, report: Path) -> None:
    page = watched.page
    page.set_viewport_size({"width": 400, "height": 800})
    for name in ("index.html", "apart/index.html", "broken/index.html"):
        page.goto((report / name).as_uri())
        assert page.evaluate("document.documentElement.scrollWidth") <= 400, f"{name} is wider than the screen"
    open_scene(watched, report)
    first, second = (page.locator(f"#{pane}").bounding_box() for pane in ("pane-a", "pane-b"))
    assert first is not None and second is not None
    assert second["y"] >= first["y"] + first["height"] and first["width"] == pytest.approx(second["width"])
    page.locator("#pane-b").scroll_into_view_if_needed()
    box = page.locator("#pane-b").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] - 2, box["y"] + box["height"] / 2)
    assert page.locator("#probe").inner_text().startswith(f"pixel {WIDTH - 1},")
    assert all(value > 0 for value in shown_radiance(page, "povray"))
    watched.check()


def test_where_a_deviation_lives_is_said_with_what_was_switched_off(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    section = page.locator("#observe-ring")
    assert "where: in caustic: it goes when bodies that mirror or refract are black" in section.inner_text()
    assert "by ablation it is in caustic" in page.locator(".findings").inner_text()
    section.get_by_text("What was switched off").click()
    rows = section.locator("details.where tbody tr").all_inner_texts()
    assert [row.split("\t")[0] for row in rows] == ["caustic", "refraction", "caustic"]
    assert "goes" in rows[0] and "0.3" in rows[0] and "−0.001 … 0.005" in rows[0]
    assert "not rendered: about 9 CPU s each" in rows[1]
    assert "50\u202f%" in rows[2] and "46\u202f% of that" in rows[2]
    watched.check()
    page.goto((report / "alike" / "index.html").as_uri())
    assert page.locator("details.where").count() == 0, "engines that agree have nothing to look for"
