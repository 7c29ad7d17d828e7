"""The table of agreement: one row a number, the worst part of it, and a page that says what the file says."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.report.synthetic import write_run
from vitrail.base.record import read_record
from vitrail.judge.comparison import Interval, TolerancePart, Verdict
from vitrail.judge.records import Results
from vitrail.report.agreement_page import BEGIN
from vitrail.study.agreement import Agreement, agreement

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def results(tmp_path: Path) -> Results:
    return write_run(tmp_path)


def with_parts(results: Results, *parts: tuple[str, float, Verdict]) -> Results:
    """The first scene with one number of these parts: name, difference and verdict, each surely within 0.001."""
    scene = results.scenes[0]
    observation = scene.observations[0]
    first = observation.comparisons[0]
    made = tuple(
        first.model_copy(
            update={
                "metric": f"shift.{name}",
                "difference": difference,
                "interval": Interval(low=difference - 0.001, high=difference + 0.001, level=0.99, method="stated"),
                "tolerance": 0.05,
                "tolerance_parts": (
                    TolerancePart(source="threshold", amount=0.03, reason="seen"),
                    TolerancePart(source="certificate", amount=0.02, reason="bumps"),
                ),
                "verdict": verdict,
            }
        )
        for name, difference, verdict in parts
    )
    shown = observation.model_copy(update={"comparisons": made})
    return results.model_copy(update={"scenes": (scene.model_copy(update={"observations": (shown,)}),)})


def test_a_number_gives_the_row_of_its_worst_part(results: Results) -> None:
    made = with_parts(results, ("red", 0.01, Verdict.AGREES), ("blue", -0.04, Verdict.AGREES))
    (row,) = agreement([made]).rows
    assert (row.metric, row.part, row.difference) == ("shift", "blue", -0.04)
    made = with_parts(results, ("red", 0.01, Verdict.DEVIATES), ("blue", -0.04, Verdict.AGREES))
    assert agreement([made]).rows[0].part == "red"


@pytest.mark.parametrize(("difference", "beyond"), [(0.01, 0.0), (0.0205, 0.0), (0.04, 0.019), (-0.04, 0.019)])
def test_beyond_is_what_the_certificate_surely_does_not_explain(
    results: Results, difference: float, beyond: float
) -> None:
    (row,) = agreement([with_parts(results, ("red", difference, Verdict.AGREES))]).rows
    assert row.certificate == 0.02
    assert row.beyond == pytest.approx(beyond, abs=1e-12)


def test_the_last_run_of_a_scene_counts(results: Results) -> None:
    first = with_parts(results, ("red", 0.01, Verdict.AGREES))
    second = with_parts(results, ("red", 0.02, Verdict.AGREES))
    (row,) = agreement([first, second]).rows
    assert row.difference == 0.02


# --- what is published ----------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def published() -> Agreement:
    return read_record(Agreement, ROOT / "docs" / "agreement.json.gz")


def test_every_scene_is_in_the_table_and_was_judged(published: Agreement) -> None:
    shipped = {path.stem for path in (ROOT / "scenes").glob("*/*.yaml")}
    assert {scene.name for scene in published.scenes} == shipped
    assert all(scene.status == "judged" for scene in published.scenes)
    assert {row.scene for row in published.rows} == shipped


def test_what_lies_beyond_the_certificate_is_explained_by_name(published: Agreement) -> None:
    """Findings are few and have a cause that a person wrote down above the tables."""
    text = (ROOT / "docs" / "agreement.md").read_text().partition(BEGIN)[0]
    for row in published.rows:
        if row.beyond > 0 or row.verdict == "deviates":
            assert f"`{row.scene}`" in text, f"{row.scene}.{row.observation}: {row.metric} has no cause"
