"""One comparison in a sentence: units are told, doubt says what would end it, and despair says so."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.report.synthetic import write_run
from vitrail.commands.comparison_sentence import sentence
from vitrail.judge.comparison import Attribution, Cause, ObservationResult, Verdict


@pytest.fixture(scope="module")
def unsure(tmp_path_factory: pytest.TempPathFactory) -> ObservationResult:
    results = write_run(Path(tmp_path_factory.mktemp("run")))
    (scene,) = [scene for scene in results.scenes if scene.name == "unsure"]
    return scene.observations[0]


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (None, ""),
        (2.34, "; 2.3 times the samples would decide"),
        (452.0, "; 452 times the samples would decide"),
        (5.2e11, "; no affordable number of samples would decide: choose a patch with more light"),
    ],
)
def test_doubt_says_what_would_end_it(unsure: ObservationResult, factor: float | None, words: str) -> None:
    (doubt, *_) = [each for each in unsure.comparisons if each.verdict is Verdict.INCONCLUSIVE]
    changed = doubt.model_copy(update={"sample_factor": factor, "attribution": None})
    assert sentence(unsure, changed).endswith("]" + words)


def test_engines_have_their_names_in_a_sentence(unsure: ObservationResult) -> None:
    (doubt, *_) = [each for each in unsure.comparisons if each.verdict is Verdict.INCONCLUSIVE]
    for engine, words in (("povray", "(model of POV-Ray: why)"), ("tracer", "(model of the tracer: why)")):
        cause = Attribution(cause=Cause.MODEL, engine=engine, reason="why")
        assert words in sentence(unsure, doubt.model_copy(update={"attribution": cause}))


def test_a_share_has_no_unit_and_a_length_has_metres(unsure: ObservationResult) -> None:
    (doubt, *_) = [each for each in unsure.comparisons if each.verdict is Verdict.INCONCLUSIVE]
    changed = {unit: doubt.model_copy(update={"unit": unit, "value": 0.25}) for unit in ("1", "m")}
    assert "it is 0.25, should" in sentence(unsure, changed["1"])
    assert "it is 0.25 m, should" in sentence(unsure, changed["m"])
