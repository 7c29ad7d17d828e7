"""How many more samples a scene in doubt is given."""

from __future__ import annotations

import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import Comparison, ObservationResult, Pair, PatchRecord, TolerancePart, Verdict
from vitrail.judge.records import EngineRun, SceneResult, Status
from vitrail.judge.verdict import Measured, Noise, decide, overall
from vitrail.pipeline.more_samples import LEAST, SAFETY, more, offer, price_s, wanted_factor


def compared(value: float, error: float) -> Comparison:
    part = TolerancePart(source="threshold", amount=0.01, reason="for this test")
    return decide(Measured(Pair.TRACER_POVRAY, "flux", "1", value, 1.0, Noise(error)), [part], 0.95)


def engine(seconds: dict[str, float], photons: int | None) -> EngineRun:
    total = seconds["total"]
    return EngineRun(engine="x", version="1", cpu_s=total, photons_stored=photons, record={"cpu_s": seconds})


def scene(*comparisons: Comparison, engines: tuple[EngineRun, ...] = ()) -> SceneResult:
    verdict = overall(entry.verdict for entry in comparisons)
    observation = ObservationResult(
        name="spot",
        phenomenon=Phenomenon.CAUSTIC,
        patch=PatchRecord(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1)),
        comparisons=comparisons,
        verdict=verdict or Verdict.INCONCLUSIVE,
    )
    return SceneResult(
        name="s",
        title="",
        source="",
        status=Status.JUDGED,
        observations=(observation,),
        verdict=verdict,
        engines=engines,
        exit_code=5,
    )


def test_the_most_doubtful_number_asks() -> None:
    little, much = compared(1.0, 0.008), compared(1.0, 0.015)
    assert little.sample_factor is not None and much.sample_factor is not None
    assert wanted_factor(scene(little, much)) == pytest.approx(SAFETY * much.sample_factor)
    assert wanted_factor(scene(little)) == pytest.approx(SAFETY * little.sample_factor)


def test_one_number_that_seems_to_deviate_decides_a_scene_and_asks_for_less() -> None:
    much, off = compared(1.0, 0.1), compared(1.03, 0.015)
    assert off.verdict is Verdict.INCONCLUSIVE and off.sample_factor is not None
    assert wanted_factor(scene(much, off)) == pytest.approx(SAFETY * off.sample_factor)


def test_a_wish_is_never_for_less_than_twice_the_samples() -> None:
    assert wanted_factor(scene(compared(1.0, 0.00515))) == LEAST


def test_a_price_grows_as_the_work_of_each_phase_does() -> None:
    # Half of the time is rays and gathers, the rest photons: eight times both, and four times the photons a gather.
    gathers = engine({"total": 2.0, "photon_pass": 1.0, "camera": 0.25, "gather": 0.75}, photons=1000)
    assert price_s([gathers], 8.0) == pytest.approx(8 + 8 * 4)
    assert price_s([gathers], 8.0, fixed_samples=True) == pytest.approx(8 + 4)
    assert price_s([engine({"total": 2.0, "camera": 1.5}, photons=None)] * 2, 8.0) == pytest.approx(2 * 16)


def test_what_is_too_dear_is_priced_and_not_bought() -> None:
    doubtful = scene(compared(1.0, 0.015), engines=(engine({"total": 1.0, "camera": 1.0}, photons=None),))
    factor = wanted_factor(doubtful) or 0.0
    rich, poor = offer(doubtful, factor, 60.0), offer(doubtful, 0.99 * factor, 60.0)
    assert rich is not None and rich.affordable and rich.cpu_s == pytest.approx(factor)
    assert poor is not None and not poor.affordable
    assert f"about {factor:.0f} times the samples would decide, for about {factor:.0f} CPU s more" in poor.reason
    assert "of the 60 CPU s" in poor.reason


def test_what_no_number_of_samples_decides_says_so() -> None:
    edge = offer(scene(compared(1.01, 0.001)), 60.0, 60.0)
    assert edge is not None and not edge.affordable and edge.factor is None and "cannot decide" in edge.reason
    assert offer(scene(compared(1.0, 0.001)), 60.0, 60.0) is None


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
