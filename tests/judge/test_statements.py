"""How close things are, in words: bounds rounded up, the light first, what is open never called a disagreement."""

from __future__ import annotations

import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.bound import percent, reach, worst
from vitrail.judge.comparison import Comparison, ObservationResult, Pair, PatchRecord, TolerancePart, Verdict
from vitrail.judge.statements import observation_statement, run_statement, scene_headline, scene_statement
from vitrail.judge.verdict import Measured, Noise, decide, overall

LEVEL = 0.9999


def number(
    metric: str, difference: float, error: float, tolerance: float, pair: Pair = Pair.TRACER_POVRAY
) -> Comparison:
    ideal = 0.0 if metric.split(".")[0] in ("centroid_shift", "displacement") else 1.0
    unit = "m" if ideal == 0 else "1"
    measured = Measured(pair, metric, unit, ideal + difference, ideal, Noise(error, 63, "half images"))
    return decide(measured, [TolerancePart(source="threshold", amount=tolerance, reason="of this test")], LEVEL)


def observation(phenomenon: Phenomenon, *comparisons: Comparison) -> ObservationResult:
    patch = PatchRecord(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1))
    return ObservationResult(
        name="spot",
        phenomenon=phenomenon,
        patch=patch,
        comparisons=comparisons,
        verdict=overall(entry.verdict for entry in comparisons) or Verdict.INCONCLUSIVE,
        bound=worst(comparisons),
        statement=observation_statement(phenomenon, comparisons),
    )


FLUX = number("flux_ratio.red", 0.004, 0.0, 0.01)
WIDER_FLUX = number("flux_ratio.blue", -0.0095, 0.0, 0.01)
PLACE = number("centroid_shift.u", 0.0005, 0.0, 0.001)
OPEN_PLACE = number("centroid_shift.v", 0.0005, 0.0003, 0.001)
FAR_FLUX = number("flux_ratio.green", 0.2, 0.001, 0.01)
TRUTH = number("caustic_flux.red", 0.002, 0.0, 0.01, Pair.TRACER_TRUTH)


def test_a_caustic_says_its_light_and_its_place_by_their_widest_numbers() -> None:
    told = observation_statement(Phenomenon.CAUSTIC, [FLUX, WIDER_FLUX, PLACE])
    assert told == "The caustic agrees to within 0.95 %, its place to 0.50 mm (95 %)."


def test_what_is_open_agrees_as_far_as_is_known() -> None:
    told = observation_statement(Phenomenon.CAUSTIC, [FLUX, OPEN_PLACE])
    assert told == ("The caustic agrees to within 0.40 %, its place to 1.1 mm (tolerance 1.0 mm not yet shown) (95 %).")
    assert OPEN_PLACE.verdict is Verdict.INCONCLUSIVE
    assert OPEN_PLACE.statement == "agrees to within 1.1 mm (95 %; tolerance 1.0 mm not yet shown at 99.99 %)"


def test_what_95_percent_show_already_is_open_at_the_level_of_the_run() -> None:
    nearly = number("flux_ratio.red", 0.004, 0.0025, 0.01)
    assert nearly.bound is not None and nearly.bound.amount < nearly.tolerance
    assert observation_statement(Phenomenon.CAUSTIC, [nearly]) == (
        "The caustic agrees to within 0.90 % (tolerance 1.0 % not yet shown at the run's level) (95 %)."
    )


def test_a_deviation_is_said_before_the_agreement_beside_it() -> None:
    told = observation_statement(Phenomenon.CAUSTIC, [FLUX, FAR_FLUX, PLACE])
    assert told == ("The caustic deviates by 20 % (tolerance 1.0 %), its place agrees to within 0.50 mm (95 %).")


def test_closed_forms_follow_the_other_engine_and_lead_where_there_is_none() -> None:
    both = observation_statement(Phenomenon.CAUSTIC, [FLUX, TRUTH])
    alone = observation_statement(Phenomenon.CAUSTIC, [TRUTH])
    assert both == (
        "The caustic agrees to within 0.40 %; the tracer agrees with the closed form to within 0.20 % (95 %)."
    )
    assert alone == "The caustic of the tracer agrees with the closed form to within 0.20 % (95 %)."


def test_an_observation_without_light_says_what_it_has() -> None:
    told = observation_statement(Phenomenon.REFRACTION, [number("displacement.u", -0.9997, 0.0, 0.001)])
    assert told.startswith("The refracted picture deviates by 1.0 m in place")


def test_numbers_that_are_missing_are_counted() -> None:
    assert "2 of its numbers could not be measured" in observation_statement(Phenomenon.CAUSTIC, [FLUX], ["a", "b"])


def test_a_scene_tells_its_widest_phenomena_first() -> None:
    shadow = observation(Phenomenon.SHADOW, number("radiance_ratio.red", 0.0001, 0.0, 0.01))
    told = scene_statement([shadow, observation(Phenomenon.CAUSTIC, OPEN_PLACE)])
    assert told == (
        "The caustic agrees to within 1.1 mm in place (tolerance 1.0 mm not yet shown); "
        "the shadow agrees to within 0.010 % (95 %)."
    )
    assert scene_statement([shadow]) == shadow.statement


def test_a_run_counts_without_calling_the_open_a_disagreement() -> None:
    assert run_statement({"agrees": 2}) == "2 of 2 scenes agree."
    assert run_statement({"inconclusive": 1}) == (
        "The scene agrees as far as is known, within a bound wider than the tolerance."
    )
    assert run_statement({"agrees": 1, "deviates": 2}) == "1 of 3 scenes agrees; 2 deviate."


@pytest.mark.parametrize(("difference", "error"), [(0.0, 0.0), (0.009, 0.0), (0.004, 0.001), (-0.02, 0.004)])
def test_a_bound_is_one_tolerance_wide_or_less_exactly_where_the_number_agrees(difference: float, error: float) -> None:
    entry = number("flux_ratio.red", difference, error, 0.01)
    assert entry.bound is not None and entry.bound.over_tolerance is not None
    assert (entry.bound.over_tolerance <= 1) is (entry.verdict is Verdict.AGREES)
    assert entry.bound.amount <= reach(entry.interval), "95 % is less than the run asks for"


@pytest.mark.parametrize(("level", "words"), [(0.95, "95 %"), (0.99961352, "99.961 %"), (0.9999987, "99.99987 %")])
def test_a_level_has_no_more_digits_than_it_needs(level: float, words: str) -> None:
    assert percent(level) == words


def test_a_headline_is_the_widest_part_and_a_doubt_comes_before_agreement() -> None:
    shadow = observation(Phenomenon.SHADOW, number("radiance_ratio.red", 0.0099, 0.0, 0.01))
    spot = observation(Phenomenon.CAUSTIC, FLUX, TRUTH)
    open_truth = number("caustic_flux.red", 0.004, 0.004, 0.01, Pair.TRACER_TRUTH)
    assert scene_headline([spot]) == "The caustic agrees to within 0.40 % (95 %)."
    assert scene_headline([spot, shadow]) == "The shadow agrees to within 0.99 % (95 %)."
    assert scene_headline([observation(Phenomenon.CAUSTIC, FLUX, open_truth), shadow]) == (
        "The caustic of the tracer agrees with the closed form to within 1.2 % (tolerance 1.0 % not yet shown) (95 %)."
    )
    assert scene_headline([]) == ""
