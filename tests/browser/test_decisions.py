"""A reader accepts and rejects in the report; the exported file is what `vitrail bless --from` reads."""

from __future__ import annotations

from pathlib import Path

from tests.browser.conftest import Watched
from vitrail.study.compare.accept import decisions_of


def test_decisions_outlive_the_page_and_are_exported(watched: Watched, report: Path, tmp_path: Path) -> None:
    page = watched.page
    page.goto((report / "apart" / "index.html").as_uri())
    page.get_by_role("button", name="Reject").click()
    page.get_by_label("because").fill("the ring is too bright")
    page.goto((report / "alike" / "index.html").as_uri())
    page.get_by_label("because").fill("as the closed form")
    page.locator("h1").click()
    page.keyboard.press("a")
    page.goto((report / "index.html").as_uri())
    assert page.locator("#decisions-count").inner_text() == "1 accepted, 1 rejected"
    with page.expect_download() as started:
        page.get_by_role("button", name="Export").click()
    path = tmp_path / "decisions.json"
    started.value.save_as(path)
    assert [(d["scene"], d["decision"], d["because"]) for d in decisions_of(path)] == [
        ("alike", "accept", "as the closed form"),
        ("apart", "reject", "the ring is too bright"),
    ]
    assert f'"folder": "{report}"' in path.read_text()
    page.get_by_role("button", name="Forget them").click()
    page.reload()
    assert page.locator("#decisions").is_hidden()
    watched.check()


def test_a_scene_that_failed_offers_nothing_to_accept(watched: Watched, report: Path) -> None:
    watched.page.goto((report / "broken" / "index.html").as_uri())
    assert watched.page.locator("#decide").count() == 0
    watched.check()
