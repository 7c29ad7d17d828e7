"""From numbers to the verdict of an observation: which tolerance counts, what widens it, and what is missing."""

from __future__ import annotations

from dataclasses import replace

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import ObservationResult, Pair, PatchRecord, Verdict
from vitrail.judge.judgement import judge_observation
from vitrail.judge.lost_light import LostLight, lost_light
from vitrail.judge.observe import Observed
from vitrail.judge.references import Truth
from vitrail.judge.rules import Rule
from vitrail.judge.thresholds import Thresholds
from vitrail.judge.verdict import Measured, Noise
from vitrail.scene.model import Observation, Patch

RULES = Thresholds(0.01, {"flux": Rule("relative", 0.01, "for this test")}, {}, {})
PATCH = Patch(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1))


def measured(pair: Pair, value: float) -> Measured:
    return Measured(pair, "flux", "1", value, 1.0, Noise(0.0))


def observed(*numbers: Measured, truths: tuple[Truth | None, ...] | None = None) -> Observed:
    return Observed(
        observation=Observation(name="spot", phenomenon=Phenomenon.CAUSTIC, patch=PATCH),
        patch=PatchRecord(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1)),
        half_edge_m=1.0,
        measured=numbers,
        truths=truths or (None,) * len(numbers),
        profiles=(),
        unmeasured=(),
    )


def judged(found: Observed, residual: float = 0.0) -> ObservationResult:
    return judge_observation(found, RULES, lambda phenomenon, whole_over_light: residual, 0.99)


def test_the_certificate_widens_what_povray_takes_part_in_and_nothing_else() -> None:
    pairs = (Pair.TRACER_POVRAY, Pair.POVRAY_TRUTH, Pair.TRACER_TRUTH, Pair.TRACER_STORED)
    result = judged(observed(*(measured(pair, 1.02) for pair in pairs)), residual=0.02)
    assert [entry.verdict for entry in result.comparisons] == [
        Verdict.AGREES,
        Verdict.AGREES,
        Verdict.DEVIATES,
        Verdict.DEVIATES,
    ]
    assert [part.source for part in result.comparisons[0].tolerance_parts] == ["threshold", "certificate"]
    assert "states 0.02 for caustic" in result.comparisons[0].tolerance_parts[1].reason


def test_what_limits_cut_widens_every_number_and_what_povray_drops_only_its_own() -> None:
    pairs = (Pair.TRACER_POVRAY, Pair.TRACER_TRUTH)
    found = observed(*(measured(pair, 1.02) for pair in pairs))
    lost = LostLight(cut=0.02)
    result = judged(replace(found, lost=lost))
    assert [entry.verdict for entry in result.comparisons] == [Verdict.AGREES, Verdict.AGREES]
    assert [part.source for part in result.comparisons[1].tolerance_parts] == ["threshold", "cut"]
    lost = LostLight(dropped=0.02, least_branch=1e-4)
    result = judged(replace(found, lost=lost))
    assert [entry.verdict for entry in result.comparisons] == [Verdict.AGREES, Verdict.DEVIATES]
    allowed = result.comparisons[0].tolerance_parts[1]
    assert (allowed.source, round(allowed.amount, 12)) == ("dropped", round(0.02 / 0.98 - 0.0002, 12))
    assert "POV-Ray drops branches below 0.0001" in allowed.reason


def test_lost_light_is_read_from_the_run_records_of_both_engines() -> None:
    weak = [{"below": 1e-3, "share": 0.3}, {"below": 1e-4, "share": 0.2}, {"below": 1e-5, "share": 0.1}]
    ledger = {"cut": 0.01, "weak_branches": weak}
    tracer = {"camera_ledger": {}, "views": [{"name": "spot", "camera_ledger": ledger}]}
    found = [
        lost_light({"tracer": tracer, "povray": povray}, "spot")
        for povray in ({"adc_bailout": 1e-4}, {"adc_bailout": 5e-5}, {})
    ]
    assert [each.dropped for each in found] == [0.2, 0.2, 0.0]
    assert {each.cut for each in found} == {0.01}
    assert lost_light({"tracer": tracer, "povray": {"adc_bailout": 1e-4}}, None) == LostLight(least_branch=1e-4)


def test_resolution_allows_what_smoothing_does_to_a_number_and_no_more() -> None:
    smoothed = replace(measured(Pair.TRACER_TRUTH, 1.02), smoothing=0.015)
    result = judged(observed(smoothed, replace(smoothed, smoothing=0.0)))
    assert [entry.verdict for entry in result.comparisons] == [Verdict.AGREES, Verdict.DEVIATES]
    assert [part.source for part in result.comparisons[0].tolerance_parts] == ["threshold", "resolution"]


def test_a_certificate_is_asked_how_much_larger_the_whole_is_than_its_light() -> None:
    asked: list[float] = []
    number = replace(measured(Pair.TRACER_POVRAY, 1.0), settings={"whole_over_light": 3.0})
    judge_observation(observed(number), RULES, lambda _, whole: asked.append(whole) or 0.0, 0.99)
    assert asked == [3.0]


def test_a_formula_that_states_its_tolerance_is_held_to_it() -> None:
    strict = Truth("flux", 1.0, "f", "s", {"any": ("relative", 0.001, "exact"), "povray": ("relative", 0.1, "coarse")})
    numbers = (measured(Pair.TRACER_TRUTH, 1.005), measured(Pair.POVRAY_TRUTH, 1.005))
    result = judged(observed(*numbers, truths=(strict, strict)))
    assert [entry.verdict for entry in result.comparisons] == [Verdict.DEVIATES, Verdict.AGREES]
    assert [entry.tolerance_parts[0].source for entry in result.comparisons] == ["reference", "reference"]


def test_what_could_not_be_measured_has_not_agreed() -> None:
    whole = observed(measured(Pair.TRACER_POVRAY, 1.0))
    assert judged(whole).verdict is Verdict.AGREES
    assert judged(replace(whole, unmeasured=("no light on the patch",))).verdict is Verdict.INCONCLUSIVE
    red = observed(measured(Pair.TRACER_POVRAY, 2.0))
    assert judged(replace(red, unmeasured=("no light on the patch",))).verdict is Verdict.DEVIATES
    assert judged(observed()).verdict is Verdict.INCONCLUSIVE, "nothing measured is no agreement"
