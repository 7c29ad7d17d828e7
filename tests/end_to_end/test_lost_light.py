"""POV-Ray drops weak branches, and a pile of panes has many: the numbers allow what the tracer's ledger says of it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.end_to_end.conftest import Compare
from vitrail.judge.comparison import Cause, Verdict

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

SCENE = Path(__file__).parent / "pile_of_panes.yaml"


def test_what_povray_drops_is_a_difference_of_the_translation_and_not_of_the_model(compared: Compare) -> None:
    (scene,) = compared(SCENE, overrides={"samples": 2}).scenes
    (red, *_) = scene.observations[0].comparisons
    own = sum(part.amount for part in red.tolerance_parts if part.source == "threshold")
    dropped = sum(part.amount for part in red.tolerance_parts if part.source == "dropped")
    assert own < red.difference < own + dropped
    assert dropped == pytest.approx(red.difference, rel=0.05)
    assert red.verdict is Verdict.AGREES
    assert red.attribution is not None and red.attribution.cause is Cause.TRANSLATION
