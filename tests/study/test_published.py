"""What the documents say about the studies is what the stored result files say."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from vitrail.study.task_log import read_rows
from vitrail.study.tradeoff.analysis import analyse_rows

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ROOT / "docs" / "studies"
TRADEOFFS = ("ball_lens", "prism_screen")


@pytest.mark.parametrize("name", TRADEOFFS)
def test_the_stored_analysis_is_that_of_the_stored_samples(name: str) -> None:
    stored = json.loads((STUDIES / name / "tradeoff.json").read_text())
    again = json.loads(json.dumps(analyse_rows(read_rows(STUDIES / name))))
    assert stored["phenomena"] == again["phenomena"]
    assert stored["failures"] == []


def test_the_readme_quotes_the_price_of_a_caustic() -> None:
    stored = json.loads((STUDIES / "ball_lens" / "tradeoff.json").read_text())
    sentence = stored["phenomena"]["caustic"]["sentence"]
    assert sentence in " ".join((ROOT / "README.md").read_text().split())


@pytest.mark.parametrize("name", TRADEOFFS)
def test_the_page_of_studies_quotes_every_sentence(name: str) -> None:
    stored = json.loads((STUDIES / name / "tradeoff.json").read_text())
    page = " ".join((STUDIES / "README.md").read_text().split())
    for entry in stored["phenomena"].values():
        assert entry["sentence"] in page


def test_the_plan_saves_and_changes_nothing() -> None:
    stored = json.loads((STUDIES / "plans.json").read_text())
    assert len(stored["scenes"]) >= 30
    for scene in stored["scenes"]:
        assert scene["failure"] is None, scene["name"]
        whole = scene["differences"]["everything"]
        # Noise alone is 1 in these units; its own scatter over thousands of pixels is a few per cent.
        noisy = whole["sigmas"] is not None and whole["sigmas"] < 1.2 and whole["outside_noise"] < 1e-6
        assert whole["same_bits"] or noisy, scene["name"]
        # CPU seconds of equal work scatter by a tenth on a shared machine.
        assert scene["cpu_s"]["plan"] <= 1.15 * scene["cpu_s"]["everything"] + 0.02, scene["name"]
