"""Results for machines: what GitHub and JUnit readers get from a run with every kind of end."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest

from tests.report.synthetic import write_run
from vitrail.commands.result_formats import github_annotations, job_summary, junit
from vitrail.judge.records import Results


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Results:
    """Scenes that agree, deviate, stay in doubt, and one whose engine failed."""
    return write_run(tmp_path_factory.mktemp("run"))


def test_github_gets_an_annotation_at_the_line_of_each_observation_that_does_not_agree(results: Results) -> None:
    found = github_annotations(results, lambda scene, observation: 7 if observation else 1)
    heads = [line.split("::")[1] for line in found]
    assert heads == [
        "error file=scenes/apart.yaml,line=7,title=apart.ring deviates",
        "warning file=scenes/unsure.yaml,line=7,title=unsure.ring known to 2.2 %25 (inconclusive)",
        "error file=scenes/broken.yaml,line=1,title=engine_failed",
    ]
    assert all("\n" not in line for line in found), "a line break would end the command"
    assert "::The caustic agrees to within 2.2 %25" in found[1], "how close comes first"
    assert "%0Aagain: vitrail compare scenes/apart.yaml" in found[0]
    assert "%0Awhere: in caustic: it goes when" in found[0]


def test_the_job_summary_has_a_row_a_scene(results: Results) -> None:
    rows = [line for line in job_summary(results).splitlines() if line.startswith("| ")][1:]
    cells = [row.split(" | ") for row in rows]
    assert [(row[0], row[2]) for row in cells] == [
        ("| alike", "agrees"),
        ("| apart", "deviates"),
        ("| unsure", "inconclusive"),
        ("| broken", "engine_failed"),
    ]
    assert cells[0][1].startswith("The caustic agrees to within 0.60 %")
    assert "flux_ratio.red deviates by 30 %" in rows[1] and "Parse Error" in rows[3]


def test_junit_counts_what_failed_and_what_could_not_be_judged(results: Results) -> None:
    suites = {suite.get("name"): suite for suite in ElementTree.fromstring(junit(results))}
    counted = {name: (s.get("tests"), s.get("failures"), s.get("errors")) for name, s in suites.items()}
    assert counted == {
        "alike": ("1", "0", "0"),
        "apart": ("1", "1", "0"),
        "unsure": ("1", "1", "0"),
        "broken": ("1", "0", "1"),
    }
    failure = suites["apart"].find("testcase/failure")
    assert failure is not None and failure.get("type") == "deviates" and "should be 1" in str(failure.text)
    assert str(failure.get("message")).startswith("The caustic deviates by 30 %")
    known = {each.get("name"): each.get("value") for each in suites["unsure"].iter("property")}
    assert known["tracer-vs-povray profile_correlation"] == "agrees to within 0.10 % (95 %)"
    assert "tolerance 2.0 % not yet shown" in str(known["statement"])
