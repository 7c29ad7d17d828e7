"""Both engines of our own pass what every foreign renderer must pass first."""

from __future__ import annotations

import pytest

from tests.end_to_end.conftest import Compare
from vitrail.judge.comparison import Verdict
from vitrail.pipeline.conformance import SCENES, conformance_scenes

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]


def test_both_engines_agree_with_the_closed_forms_of_the_conformance_scenes(compared: Compare) -> None:
    results = compared(*(each.path for each in conformance_scenes()), quality="normal")
    assert [(scene.name, scene.verdict) for scene in results.scenes] == [(name, Verdict.AGREES) for name in SCENES]
    pairs = {each.pair.value for scene in results.scenes for seen in scene.observations for each in seen.comparisons}
    assert pairs == {"tracer-vs-povray", "tracer-vs-truth", "povray-vs-truth"}
