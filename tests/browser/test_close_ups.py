"""The picture of an observation: large, both sides with their difference, and its place in the scene beside it."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.browser.conftest import Watched
from tests.report.synthetic import HEIGHT, OUTLINE, WIDTH
from vitrail.images.exr import read_image

pytestmark = pytest.mark.browser

OBSERVATION = "#observe-ring"


def opened(watched: Watched, report: Path, width: int) -> Page:
    page = watched.page
    page.set_viewport_size({"width": width, "height": 900})
    page.goto((report / "apart" / "index.html").as_uri())
    page.locator(f"{OBSERVATION} .close-up").scroll_into_view_if_needed()
    return page


def figures(page: Page) -> list[dict[str, float]]:
    boxes = [each.bounding_box() for each in page.locator(f"{OBSERVATION} .close-up figure").all()]
    return [box for box in boxes if box is not None]  # type: ignore[misc]


def test_both_sides_their_difference_and_the_place_are_shown_large(watched: Watched, report: Path) -> None:
    page = opened(watched, report, 1280)
    images = page.locator(f"{OBSERVATION} .close-up img")
    assert [image.get_attribute("alt") for image in images.all()] == [
        "ring, Tracer",
        "ring, POV-Ray",
        "ring, difference",
        "where ring lies in the scene",
    ]
    page.wait_for_function("[...document.querySelectorAll('.close-up img')].every(each => each.naturalWidth > 0)")
    assert all(box["width"] >= 240 for box in figures(page)), "five times the 48 pixels of the view"
    assert page.locator(f"{OBSERVATION} svg.plot").first.is_visible(), "the curve stands with the pictures"
    assert "48 × 32 pixels, 4 samples per pixel" in page.locator(OBSERVATION).inner_text()
    watched.check()


def test_the_patch_is_outlined_where_it_lies_in_the_scene(watched: Watched, report: Path) -> None:
    page = opened(watched, report, 1280)
    scene = page.locator(f"{OBSERVATION} .place img").bounding_box()
    drawn = page.locator(f"{OBSERVATION} .place polygon:not(.outside)").bounding_box()
    assert scene is not None and drawn is not None
    left, right = min(x for x, _ in OUTLINE) / WIDTH, max(x for x, _ in OUTLINE) / WIDTH
    top, foot = min(y for _, y in OUTLINE) / HEIGHT, max(y for _, y in OUTLINE) / HEIGHT
    assert (drawn["x"] - scene["x"]) / scene["width"] == pytest.approx(left, abs=0.02)
    assert (drawn["x"] + drawn["width"] - scene["x"]) / scene["width"] == pytest.approx(right, abs=0.02)
    assert (drawn["y"] - scene["y"]) / scene["height"] == pytest.approx(top, abs=0.02)
    assert (drawn["y"] + drawn["height"] - scene["y"]) / scene["height"] == pytest.approx(foot, abs=0.02)
    watched.check()


def test_a_close_up_is_flipped_and_probed_like_the_scene(watched: Watched, report: Path) -> None:
    page = opened(watched, report, 1280)
    page.get_by_role("button", name="Flip and probe it").click()
    page.wait_for_function("VITRAIL.image('tracer.close.ring') && VITRAIL.image('povray.close.ring')")
    assert "picture=ring" in page.url and page.locator("#picture").input_value() == "ring"
    page.keyboard.press("ArrowRight")
    assert page.locator("#probe").inner_text() == "pixel 25, 16", "one to the right of the middle of 48 x 32"
    for side in ("tracer", "povray"):
        stored = read_image(report / "apart" / f"{side}.ring.exr").radiance[16, 25]
        cells = page.locator(f"#readout tr[data-side={side}] td")
        assert [float(cells.nth(c).get_attribute("title") or "nan") for c in range(3)] == stored.tolist()
    page.keyboard.press("5")
    assert page.locator("[data-view=difference]").get_attribute("aria-checked") == "true"
    page.locator("#picture").select_option("")
    assert "picture" not in page.url and "pixel" not in page.url
    watched.check()


def test_a_phone_shows_one_close_up_under_the_other_and_nothing_beside_the_screen(
    watched: Watched, report: Path
) -> None:
    page = opened(watched, report, 400)
    boxes = figures(page)
    assert len({box["x"] for box in boxes}) == 1 and all(box["width"] > 340 for box in boxes)
    assert page.evaluate("document.documentElement.scrollWidth") == 400
    watched.check()


def test_what_differs_beside_the_patches_is_boxed_and_told(watched: Watched, report: Path) -> None:
    page = opened(watched, report, 1280)
    section = page.locator("#scan")
    assert "40 pixels at the upper left, on `wall`, are 1.7 times brighter in the tracer" in section.inner_text()
    assert "0.004" in section.inner_text() and "75 standard errors beyond" in section.inner_text()
    picture = section.locator("img").bounding_box()
    drawn = section.locator("rect.deviates").bounding_box()
    assert picture is not None and drawn is not None
    middle = [drawn["x"] + drawn["width"] / 2 - picture["x"], drawn["y"] + drawn["height"] / 2 - picture["y"]]
    assert middle[0] / picture["width"] == pytest.approx(12.5 / WIDTH, abs=0.01)
    assert middle[1] / picture["height"] == pytest.approx(8.5 / HEIGHT, abs=0.01)
    assert "Outside the patches: 40 pixels" in page.locator(".summary .statement").inner_text()
    page.goto((report / "alike" / "index.html").as_uri())
    assert "No place differs beyond noise and certificate" in page.locator("#scan").inner_text()
    watched.check()
