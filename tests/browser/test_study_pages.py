"""The pages of studies in a real browser, from disk: what they show is what their result files say."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.browser.conftest import Watched
from tests.study.published import STUDIES, published
from vitrail.report.atlas_page import limit_words, write_atlas_page
from vitrail.report.page import number
from vitrail.report.plans_page import write_plans_page
from vitrail.report.tradeoff_page import write_tradeoff_page
from vitrail.study.extremes.atlas import STACKS

pytestmark = pytest.mark.browser

GROUND = "getComputedStyle(document.body).backgroundColor"


@pytest.fixture
def tradeoff(tmp_path: Path) -> Path:
    return write_tradeoff_page(tmp_path, published("ball_lens/tradeoff.json"))


@pytest.fixture
def plans(tmp_path: Path) -> Path:
    return write_plans_page(tmp_path, published("plans/plans.json"))


@pytest.fixture
def atlas(tmp_path: Path) -> Path:
    return write_atlas_page(tmp_path, published("atlas/atlas.json"))


def _texts(page: Page, selector: str) -> list[str]:
    return [text.strip() for text in page.locator(selector).all_inner_texts()]


def test_the_trade_off_shows_its_sentence_prices_and_marks(watched: Watched, tradeoff: Path) -> None:
    watched.page.goto(tradeoff.as_uri())
    entry = published("ball_lens/tradeoff.json").phenomena["caustic"]
    assert _texts(watched.page, ".finding") == [entry.sentence]
    for engine, front in entry.by_engine:
        shown = [text.removeprefix("≤ ") for text in _texts(watched.page, f".prices td[data-engine={engine}]")]
        prices = [getattr(row, engine).cpu_s for row in entry.equal_error]
        assert shown == [number(price, 3) if price is not None else "not reached" for price in prices]
        assert watched.page.locator(f"figure .{engine} .point").count() == len(front.settings)
        assert watched.page.locator(f".{engine}-settings tbody tr").count() == len(front.settings)
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
    found = published("plans/plans.json")
    rows = watched.page.locator("#table tbody tr")
    assert rows.count() == len(found.scenes)
    for scene in found.scenes:
        row = _texts(watched.page, f"#table tr[data-scene={scene.name}] td")
        assert row[:2] == [number(scene.cpu_s[name], 3) for name in ("everything", "plan")]
        cells = watched.page.locator(f"#phenomena tr[data-scene={scene.name}] .cell")
        assert cells.count() == len(scene.required)
    watched.check()


def test_the_atlas_names_every_limit_and_links_its_scenes(watched: Watched, atlas: Path) -> None:
    watched.page.goto(atlas.as_uri())
    for axis in published("atlas/atlas.json").axes:
        for engine, found in axis.engines.items():
            shown = _texts(watched.page, f"#limits tr[data-axis={axis.name}] td[data-engine={engine}]")
            assert shown == [limit_words(axis, engine)]
            link = watched.page.locator(f"#{axis.name} a[href='scenes/{axis.name}-{engine}.yaml']")
            assert link.count() == int(found.fails)
            kept = (STUDIES / "atlas" / "scenes" / f"{axis.name}-{engine}.pov").is_file()
            assert kept or not found.fails or axis.name in STACKS
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
