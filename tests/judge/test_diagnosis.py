"""One name for many deviations: that of the plainest scene which fails."""

from __future__ import annotations

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import (
    Attribution,
    Cause,
    Comparison,
    Interval,
    ObservationResult,
    Pair,
    PatchRecord,
    Verdict,
)
from vitrail.judge.diagnosis import BASIC_FIRST, diagnose
from vitrail.judge.records import PlanEntry, SceneResult, Status

P = Phenomenon
PATCH = PatchRecord(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1))


def off(pair: Pair, engine: str | None) -> Comparison:
    return Comparison(
        pair=pair,
        metric="x",
        unit="1",
        value=2,
        ideal=1,
        difference=1,
        interval=Interval(low=1, high=1, level=0.99, method="exact"),
        tolerance=0.1,
        verdict=Verdict.DEVIATES,
        reason="far off",
        attribution=Attribution(cause=Cause.MODEL, engine=engine, reason="by this test"),
    )


def scene(name: str, seen: Phenomenon, *also: Phenomenon, engines: tuple[str | None, ...] = (), well: bool = False):
    """A scene that observes ``seen`` and requires ``also`` besides."""
    required = {seen, *also}
    verdict = Verdict.AGREES if well else Verdict.DEVIATES
    observation = ObservationResult(
        name="patch",
        phenomenon=seen,
        patch=PATCH,
        comparisons=tuple(off(Pair.TRACER_POVRAY, engine) for engine in engines),
        verdict=verdict,
    )
    return SceneResult(
        name=name,
        title="",
        source="",
        status=Status.JUDGED,
        plan=tuple(PlanEntry(phenomenon=each, required=each in required) for each in Phenomenon),
        observations=(observation,),
        verdict=verdict,
        exit_code=1,
    )


def test_every_phenomenon_has_its_place_in_the_order() -> None:
    assert set(BASIC_FIRST) == set(Phenomenon) and len(BASIC_FIRST) == len(Phenomenon)


def test_a_lost_photon_is_no_fault_of_the_tint_that_it_carries() -> None:
    """A tinted pane thrown on a floor is the more demanding scene, though tint is the more basic phenomenon."""
    pane = scene("pane", P.COLOURED_TRANSMISSION, P.REFRACTION, P.SHADOW, P.CAUSTIC, P.DIFFUSION)
    lens = scene("lens", P.CAUSTIC, P.REFRACTION, P.SHADOW)
    found = diagnose([pane, lens])
    assert (found.phenomenon, found.scene, found.observation) == (P.CAUSTIC, "lens", "patch")
    assert found.deviating == (P.COLOURED_TRANSMISSION, P.CAUSTIC)


def test_of_scenes_that_require_as_much_the_more_basic_phenomenon_is_named() -> None:
    found = diagnose([scene("prism", P.TOTAL_INTERNAL_REFLECTION, P.REFRACTION), scene("slab", P.REFRACTION, P.SHADOW)])
    assert found.phenomenon is P.REFRACTION


def test_what_agrees_is_no_witness() -> None:
    found = diagnose([scene("card", P.DIFFUSION, well=True), scene("slab", P.REFRACTION, P.REFLECTION)])
    assert (found.phenomenon, found.scene) == (P.REFRACTION, "slab")
    assert diagnose([scene("card", P.DIFFUSION, well=True)]).phenomenon is None


def test_the_engine_is_the_one_that_closed_forms_call_wrong_most_often() -> None:
    assert diagnose([scene("card", P.DIFFUSION, engines=("povray", None, "tracer", "povray"))]).engine == "povray"
    assert diagnose([scene("card", P.DIFFUSION, engines=(None,))]).engine is None
