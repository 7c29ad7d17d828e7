"""A reader accepts and rejects in the report; the exported file is what `vitrail bless --from` reads."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from tests.browser.conftest import Watched
from tests.end_to_end.test_command_line import CARD, ROOT, vitrail
from vitrail.images.exr import read_image, write_image
from vitrail.pipeline.decisions import read_decisions

pytestmark = [pytest.mark.browser, pytest.mark.slow]


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
    assert [(d.scene, d.decision, d.because) for d in read_decisions(path).decisions] == [
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


def test_an_accepted_image_becomes_the_reference_and_another_one_does_not(watched: Watched, tmp_path: Path) -> None:
    """The whole way: compare, look, accept with a reason, export, bless; and again after the image has changed."""
    (tmp_path / "references").mkdir()
    shutil.copy(ROOT / "references" / "thresholds.yaml", tmp_path / "references")
    scene, out = Path(shutil.copy(CARD, tmp_path / "card.yaml")), tmp_path / "out"
    options = ("--against", "truth", "--out", out, "--quality", "draft", "--no-views")
    # In this project no formula and no older image is known, so nothing can agree yet.
    assert vitrail("compare", scene, *options).returncode == 5
    page, exported = watched.page, tmp_path / "decisions.json"
    page.goto((out / "card" / "index.html").as_uri())
    page.get_by_role("button", name="Accept as reference").click()
    page.get_by_label("because").fill("as bright as d E / pi says")
    page.goto((out / "index.html").as_uri())
    with page.expect_download() as started:
        page.get_by_role("button", name="Export").click()
    started.value.save_as(exported)
    watched.check()
    # Another image of the same scene under the same name was never looked at.
    image = read_image(out / "card" / "tracer.exr")
    (out / "card" / "tracer.exr").unlink()
    write_image(out / "card" / "tracer.exr", image.radiance * 1.01, metadata=image.metadata)
    reference = tmp_path / "references" / "card"
    refused = vitrail("bless", "--from", exported)
    assert refused.returncode == 2 and "is not the image that was decided on" in refused.stderr, refused.stderr
    assert not reference.exists()
    # The image that was looked at is the one that is kept, with the reason that was given.
    assert vitrail("compare", scene, *options).returncode == 5
    done = vitrail("bless", "--from", exported)
    assert done.returncode == 0 and "accepted:" in done.stdout, done.stderr
    assert 'because: "as bright as d E / pi says"' in (reference / "provenance.yaml").read_text()
    kept, looked_at = read_image(reference / "reference.exr"), read_image(out / "card" / "tracer.exr")
    assert np.array_equal(kept.radiance, looked_at.radiance.astype(np.float16))
    assert vitrail("compare", scene, *options[2:], "--against", "stored").returncode == 0
