"""Who is wrong and why, from the comparisons of one observation."""

from __future__ import annotations

from vitrail.judge.attribution import attribute, headline
from vitrail.judge.comparison import Attribution, Cause, Comparison, Pair, TolerancePart, Verdict
from vitrail.judge.verdict import Measured, Noise, decide

BOTH, TRACER, POVRAY = Pair.TRACER_POVRAY, Pair.TRACER_TRUTH, Pair.POVRAY_TRUTH


def compared(pair: Pair, value: float, error: float = 0.0, certificate: float = 0.0) -> Comparison:
    parts = [TolerancePart(source="threshold", amount=0.01, reason="for this test")]
    if certificate:
        parts.append(TolerancePart(source="certificate", amount=certificate, reason="stated"))
    return decide(Measured(pair, "flux", "1", value, 1.0, Noise(error)), parts, 0.99)


def causes(*comparisons: Comparison) -> list[Attribution | None]:
    return [entry.attribution for entry in attribute(comparisons)]


def test_plain_agreement_needs_no_cause() -> None:
    assert causes(compared(BOTH, 1.005)) == [None]
    assert causes(compared(BOTH, 1.005, certificate=0.02)) == [None], "the certificate was there, but not needed"


def test_agreement_inside_the_certificate_is_translation() -> None:
    (cause,) = causes(compared(BOTH, 1.02, certificate=0.02))
    assert cause is not None and cause.cause is Cause.TRANSLATION


def test_an_interval_wider_than_the_tolerance_is_noise() -> None:
    (cause,) = causes(compared(BOTH, 1.005, error=0.1))
    assert cause is not None and cause.cause is Cause.NOISE


def test_a_whisker_over_the_tolerance_is_rounding_where_povray_rounds() -> None:
    (cause,) = causes(compared(BOTH, 1.011))
    assert cause is not None and cause.cause is Cause.NUMERICS
    (cause,) = causes(compared(TRACER, 1.011))
    assert cause is not None and cause.cause is Cause.MODEL, "the tracer writes floats and has no such excuse"


def test_the_closed_form_says_who_is_wrong() -> None:
    found = causes(compared(BOTH, 1.3), compared(TRACER, 1.3), compared(POVRAY, 1.001))
    assert found[0] is not None and (found[0].cause, found[0].engine) == (Cause.MODEL, "tracer")
    assert found[0].reason == "POV-Ray agrees with the closed forms and the tracer does not"
    found = causes(compared(BOTH, 1.3), compared(TRACER, 1.001), compared(POVRAY, 0.7))
    assert found[0] is not None and found[0].engine == "povray"
    assert found[2] is not None and found[2].engine == "povray"


def test_without_a_closed_form_nobody_is_blamed() -> None:
    (cause,) = causes(compared(BOTH, 1.3))
    assert cause is not None and cause.engine is None and "no closed form" in cause.reason
    found = causes(compared(BOTH, 1.3), compared(TRACER, 1.2), compared(POVRAY, 0.8))
    assert found[0] is not None and found[0].engine is None and "both deviate" in found[0].reason


def test_doubt_about_one_side_leaves_the_other_without_an_alibi() -> None:
    found = causes(compared(BOTH, 1.3), compared(TRACER, 1.3), compared(POVRAY, 1.0, error=0.1))
    assert found[0] is not None and found[0].engine == "tracer"
    assert "povray agrees" not in found[0].reason


def test_the_observation_takes_the_cause_that_names_an_engine() -> None:
    comparisons = attribute([compared(BOTH, 1.3), compared(TRACER, 1.3), compared(POVRAY, 1.001)])
    found = headline(comparisons, Verdict.DEVIATES)
    assert found is not None and found.engine == "tracer"
    assert headline(attribute([compared(BOTH, 1.0)]), Verdict.AGREES) is None
