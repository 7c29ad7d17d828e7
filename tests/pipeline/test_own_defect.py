"""A defect of the program itself, met in one scene: the other scenes keep their results, and its traceback is kept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.pipeline.doubles import CARD, FormulaEngine
from tests.pipeline.test_compare import RULES
from vitrail.engines.base import Rendering
from vitrail.judge.comparison import ObservationResult, Verdict
from vitrail.judge.judgement import judge_observation
from vitrail.judge.observe import Observed
from vitrail.judge.records import Results, Status, read_results
from vitrail.pipeline.compare import compare
from vitrail.pipeline.request import Request
from vitrail.scene.load import Loaded, load


@pytest.fixture
def scenes(tmp_path: Path) -> list[Loaded]:
    """Two cards, the second with another title and another name of what is observed."""
    (tmp_path / "references").mkdir()
    (tmp_path / "references" / "thresholds.yaml").write_text(RULES)
    (tmp_path / "references" / "analytic.yaml").write_text("version: 1\nscenes: {}\n")
    second = CARD.replace("Grey card", "Second card").replace("observe: [{name: card", "observe: [{name: second")
    for name, text in (("card", CARD), ("other", second)):
        (tmp_path / f"{name}.yaml").write_text(text)
    return [load(tmp_path / f"{name}.yaml") for name in ("card", "other")]


def run(tmp_path: Path, scenes: list[Loaded], tracer: FormulaEngine, jobs: int = 1) -> Results:
    engines = {"tracer": tracer, "povray": FormulaEngine("povray")}
    return compare(scenes, Request(out=tmp_path / "out", engines=engines, quality="draft", jobs=jobs))


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_defect_of_the_program_ends_its_scene_and_no_other(tmp_path: Path, scenes: list[Loaded], jobs: int) -> None:
    class Broken(FormulaEngine):
        def render(self, lowered: Any, *arguments: Any, **rest: Any) -> Rendering:
            if lowered["title"] == "Grey card":
                raise IndexError("list index out of range")
            return super().render(lowered, *arguments, **rest)

    results = run(tmp_path, scenes, Broken("tracer"), jobs=jobs)
    assert [(scene.status, scene.exit_code) for scene in results.scenes] == [(Status.DEFECT, 70), (Status.JUDGED, 0)]
    assert (results.verdict, results.exit_code) == (Verdict.AGREES, 70)
    assert "IndexError: list index out of range; its traceback is in card/traceback.txt" in results.scenes[0].message
    assert "in render\n" in (tmp_path / "out" / "card" / "traceback.txt").read_text()
    assert read_results(tmp_path / "out" / "results.json") == results


def test_a_defect_in_judging_ends_its_scene_and_no_other(
    tmp_path: Path, scenes: list[Loaded], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail_once(observed: Observed, *rest: Any) -> ObservationResult:
        if observed.observation.name == "second":
            raise ZeroDivisionError
        return judge_observation(observed, *rest)

    monkeypatch.setattr("vitrail.pipeline.judge.judge_observation", fail_once)
    results = run(tmp_path, scenes, FormulaEngine("tracer"))
    assert [scene.exit_code for scene in results.scenes] == [0, 70]
    assert "ZeroDivisionError" in (tmp_path / "out" / "other" / "traceback.txt").read_text()


def test_a_defect_in_the_search_for_where_takes_no_verdict(
    tmp_path: Path, scenes: list[Loaded], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*arguments: Any) -> None:
        raise KeyError("gone")

    monkeypatch.setattr("vitrail.pipeline.compare.search_whereabouts", fail)
    results = run(tmp_path, scenes[:1], FormulaEngine("tracer", radiance=0.55))
    (scene,) = results.scenes
    assert (scene.verdict, results.exit_code) == (Verdict.DEVIATES, 1)
    assert "KeyError: 'gone'; its traceback is in card/traceback.txt" in scene.warnings[-1]
    assert (tmp_path / "out" / "card" / "traceback.txt").is_file()
