"""Every committed page and picture of a study is what its template makes of its record, to the byte."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.study.published import ROOT, STUDIES, TRADEOFFS, published
from vitrail.base.record import read_record
from vitrail.report.agreement_page import write_agreement_page
from vitrail.report.atlas_page import atlas_text
from vitrail.report.mutants_text import mutants_text
from vitrail.report.tradeoff_page import write_tradeoff_page
from vitrail.study.agreement import Agreement


def test_the_page_of_agreement(tmp_path: Path) -> None:
    committed = (ROOT / "docs" / "agreement.md").read_text()
    (tmp_path / "agreement.md").write_text(committed)
    write_agreement_page(tmp_path / "agreement.md", read_record(Agreement, ROOT / "docs" / "agreement.json.gz"))
    assert (tmp_path / "agreement.md").read_text() == committed


def test_the_page_of_the_atlas() -> None:
    assert (STUDIES / "atlas" / "README.md").read_text() == atlas_text(published("atlas/atlas.json"))


def test_the_page_of_mutants() -> None:
    names = ("mutants/mutants.json", "mutants/limits.json", "mutants/equal_runs.json")
    assert (STUDIES / "mutants" / "README.md").read_text() == mutants_text(*(published(name) for name in names))


@pytest.mark.parametrize("name", TRADEOFFS)
def test_the_chart_of_every_front(name: str, tmp_path: Path) -> None:
    found = published(f"{name}/tradeoff.json")
    write_tradeoff_page(tmp_path, found)
    for phenomenon in found.phenomena:
        drawn = (tmp_path / f"{phenomenon}.svg").read_text()
        assert (STUDIES / name / f"{phenomenon}.svg").read_text() == drawn
