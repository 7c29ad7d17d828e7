"""The pages of studies in a real browser, from disk: what they show is what their result files say."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page

from tests.browser.conftest import Watched
from vitrail.report.atlas_page import limits, write_atlas_page
from vitrail.report.page import number
from vitrail.report.plans_page import write_plans_page
from vitrail.report.tradeoff_page import write_tradeoff_page

STUDIES = Path(__file__).resolve().parents[2] / "docs" / "studies"
GROUND = "getComputedStyle(document.body).backgroundColor"


def _stored(name: str) -> Any:
    return json.loads((STUDIES / name).read_text())


@pytest.fixture
def tradeoff(tmp_path: Path) -> Path:
    return write_tradeoff_page(tmp_path, _stored("ball_lens/tradeoff.json"))


@pytest.fixture
def plans(tmp_path: Path) -> Path:
    return write_plans_page(tmp_path, _stored("plans/plans.json"))


@pytest.fixture
def atlas(tmp_path: Path) -> Path:
    return write_atlas_page(tmp_path, _stored("atlas/atlas.json"))


def _texts(page: Page, selector: str) -> list[str]:
    return [text.strip() for text in page.locator(selector).all_inner_texts()]


def test_the_trade_off_shows_its_sentence_prices_and_marks(watched: Watched, tradeoff: Path) -> None:
    watched.page.goto(tradeoff.as_uri())
    entry = _stored("ball_lens/tradeoff.json")["phenomena"]["caustic"]
    assert _texts(watched.page, ".finding") == [entry["sentence"]]
    for engine, record in entry["engines"].items():
        shown = [text.removeprefix("≤ ") for text in _texts(watched.page, f".prices td[data-engine={engine}]")]
        prices = [row[engine]["cpu_s"] for row in entry["equal_error"]]
        assert shown == [number(price, 3) if price is not None else "not reached" for price in prices]
        assert watched.page.locator(f"figure .{engine} .point").count() == len(record["settings"])
        assert watched.page.locator(f".{engine}-settings tbody tr").count() == len(record["settings"])
    watched.check()


def test_the_numbers_of_a_mark_are_read_out_at_the_keyboard(watched: Watched, tradeoff: Path) -> None:
    watched.page.goto(tradeoff.as_uri())
    usual = watched.page.locator(".readout").inner_text()
    watched.page.locator("figure .point").first.focus()
    note = watched.page.locator(".readout").inner_text()
    assert note != usual and "CPU s" in note and "error" in note
    watched.page.keyboard.press("Tab")
    assert watched.page.locator(".readout").inner_text() not in (usual, note)
    watched.check()


def test_the_plans_are_those_of_the_result_file(watched: Watched, plans: Path) -> None:
    watched.page.goto(plans.as_uri())
    found = _stored("plans/plans.json")
    rows = watched.page.locator("#table tbody tr")
    assert rows.count() == len(found["scenes"])
    for scene in found["scenes"]:
        row = _texts(watched.page, f"#table tr[data-scene={scene['name']}] td")
        assert row[:2] == [number(scene["cpu_s"][name], 3) for name in ("everything", "plan")]
        cells = watched.page.locator(f"#phenomena tr[data-scene={scene['name']}] .cell")
        assert cells.count() == len(scene["required"])
    watched.check()


def test_the_atlas_names_every_limit_and_links_its_scenes(watched: Watched, atlas: Path) -> None:
    watched.page.goto(atlas.as_uri())
    for row in limits(_stored("atlas/atlas.json")):
        for engine, cell in row["cells"].items():
            shown = _texts(watched.page, f"#limits tr[data-axis={row['name']}] td[data-engine={engine}]")
            assert shown == [cell["words"]]
            link = watched.page.locator(f"#{row['name']} a[href='scenes/{row['name']}-{engine}.yaml']")
            assert link.count() == int(cell["fails"])
            assert not cell["fails"] or (STUDIES / "atlas" / "scenes" / f"{row['name']}-{engine}.pov").is_file()
    watched.page.locator("#limits a").first.click()
    assert watched.page.url.endswith("#thickness")
    watched.check()


@pytest.mark.parametrize("kind", ["tradeoff", "plans", "atlas"])
def test_light_and_dark(watched: Watched, kind: str, request: pytest.FixtureRequest) -> None:
    watched.page.goto(request.getfixturevalue(kind).as_uri())
    light = watched.page.evaluate(GROUND)
    watched.page.keyboard.press("t")
    assert watched.page.evaluate(GROUND) != light
    # The ink must stand out from the ground in both.
    assert watched.page.evaluate("getComputedStyle(document.querySelector('h1')).color") != watched.page.evaluate(
        GROUND
    )
    watched.check()
