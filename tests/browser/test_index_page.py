"""The index of a run in a real browser: what is listed, filtered, found, and walked through with keys."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.browser.conftest import Watched

pytestmark = pytest.mark.browser


def open_index(watched: Watched, report: Path, hash_text: str = "") -> Page:
    watched.page.goto(f"{(report / 'index.html').as_uri()}{hash_text}")
    return watched.page


def shown(page: Page) -> list[str]:
    """Names of the cards a reader sees, in the order on the screen."""
    cards = page.locator(".card:visible").all()
    places = [(card.bounding_box(), card.get_attribute("data-name")) for card in cards]
    return [str(name) for box, name in sorted(places, key=lambda each: (each[0]["y"], each[0]["x"]))]  # type: ignore[index]


def test_the_worst_scene_comes_first(watched: Watched, report: Path, tmp_path: Path) -> None:
    page = open_index(watched, report)
    assert shown(page) == ["broken", "apart", "unsure", "alike"]
    assert page.locator("h1 .badge").inner_text().split() == ["✕", "deviates"]
    page.screenshot(path=str(tmp_path / "index.png"), full_page=True)
    page.locator("#sort").select_option("name")
    assert shown(page) == ["alike", "apart", "broken", "unsure"]
    watched.check()


def test_filters_are_in_the_address(watched: Watched, report: Path) -> None:
    page = open_index(watched, report)
    page.get_by_role("button", name="deviates").click()
    assert shown(page) == ["apart"]
    assert "verdict=deviates" in page.url
    page.goto("about:blank")
    open_index(watched, report, "#verdict=inconclusive&phenomenon=caustic")
    assert shown(page) == ["unsure"]
    page.keyboard.press("Escape")
    assert len(shown(page)) == 4
    page.locator("#find").fill("too bright")
    assert shown(page) == ["apart"]
    page.locator("#find").fill("nothing like it")
    assert page.get_by_text("No scene passes these filters.").is_visible()
    page.get_by_role("button", name="Show all").click()
    assert len(shown(page)) == 4
    watched.check()


def test_a_reader_without_a_mouse_reaches_a_scene(watched: Watched, report: Path) -> None:
    page = open_index(watched, report)
    page.keyboard.press("j")
    page.keyboard.press("j")
    page.keyboard.press("Enter")
    page.wait_for_url("**/apart/index.html*")
    watched.check()


def test_the_message_of_a_failed_engine_is_shown(watched: Watched, report: Path) -> None:
    page = open_index(watched, report)
    assert "Parse Error: Expected" in page.locator(".card[data-name=broken] .message").inner_text()
    page.locator(".card[data-name=broken] h2 a").click()
    assert page.locator(".viewer").count() == 0
    assert "an engine failed: povray: Parse Error" in page.locator(".summary .message").inner_text()
    watched.check()


def test_light_and_dark_go_along_from_page_to_page(watched: Watched, report: Path) -> None:
    page = open_index(watched, report)
    ground = "getComputedStyle(document.body).backgroundColor"
    light = page.evaluate(ground)
    page.keyboard.press("t")
    dark = page.evaluate(ground)
    assert light != dark
    page.locator(".card[data-name=alike] h2 a").click()
    page.wait_for_url("**/alike/index.html*")
    assert page.evaluate(ground) == dark
    watched.check()
