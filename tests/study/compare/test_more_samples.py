"""How many more samples a scene in doubt is given."""

from __future__ import annotations

import pytest

from vitrail.judge.comparison import Comparison, ObservationResult, Pair, PatchRecord, TolerancePart, Verdict
from vitrail.judge.records import SceneResult, Status
from vitrail.judge.verdict import Measured, Noise, decide, overall
from vitrail.scene.phenomenon import Phenomenon
from vitrail.study.compare.more_samples import MOST_AT_ONCE, SAFETY, more, wanted_factor


def compared(value: float, error: float) -> Comparison:
    part = TolerancePart(source="threshold", amount=0.01, reason="for this test")
    return decide(Measured(Pair.TRACER_POVRAY, "flux", "1", value, 1.0, Noise(error)), [part], 0.95)


def scene(*comparisons: Comparison) -> SceneResult:
    verdict = overall(entry.verdict for entry in comparisons)
    observation = ObservationResult(
        name="spot",
        phenomenon=Phenomenon.CAUSTIC,
        patch=PatchRecord(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1)),
        comparisons=comparisons,
        verdict=verdict or Verdict.INCONCLUSIVE,
    )
    return SceneResult(
        name="s", title="", source="", status=Status.JUDGED, observations=(observation,), verdict=verdict, exit_code=5
    )


def test_the_most_doubtful_number_asks() -> None:
    little, much = compared(1.0, 0.008), compared(1.0, 0.015)
    assert little.sample_factor is not None and much.sample_factor is not None
    assert wanted_factor(scene(little, much)) == pytest.approx(SAFETY * much.sample_factor)
    assert wanted_factor(scene(little)) == pytest.approx(SAFETY * little.sample_factor)


def test_a_wish_has_its_bounds() -> None:
    assert wanted_factor(scene(compared(1.0, 10.0))) == MOST_AT_ONCE
    assert wanted_factor(scene(compared(1.0, 0.00515))) == 2.0, "a look that is worth its cost doubles the samples"


def test_what_is_decided_asks_for_nothing() -> None:
    assert wanted_factor(scene(compared(1.0, 0.001))) is None
    assert wanted_factor(scene(compared(1.5, 0.001))) is None
    # On the very edge no number of samples decides.
    assert wanted_factor(scene(compared(1.01, 0.001))) is None


def test_only_kinds_of_work_that_the_scene_has_are_raised() -> None:
    assert more({"samples": 4, "photons": 0, "seed": 1}, 3.0) == {"samples": 12}
    assert more({"samples": 4, "photons": 1000}, 2.5) == {"samples": 10, "photons": 2500}


def test_samples_that_the_scene_fixes_stay_as_they_are() -> None:
    assert more({"samples": 1, "photons": 1000}, 2.0, fixed_samples=True) == {"photons": 2000}
