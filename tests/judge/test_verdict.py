"""The test of equivalence, its sample factor, and the words for many."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats

from vitrail.judge.comparison import Pair, TolerancePart, Verdict
from vitrail.judge.false_alarms import sidak
from vitrail.judge.verdict import Measured, Noise, decide, overall

A, D, I = Verdict.AGREES, Verdict.DEVIATES, Verdict.INCONCLUSIVE  # noqa: E741


def measured(value: float, error: float, ideal: float = 1.0, dof: float = math.inf) -> Measured:
    return Measured(Pair.TRACER_POVRAY, "flux_ratio", "1", value, ideal, Noise(error, dof, "half images"))


def judged(value: float, error: float, tolerance: float, level: float = 0.95, dof: float = math.inf):
    part = TolerancePart(source="threshold", amount=tolerance, reason="chosen for this test")
    return decide(measured(value, error, dof=dof), [part], level)


@pytest.mark.parametrize(
    ("value", "error", "word"),
    [
        (1.01, 0.0, A),  # exact and inside
        (1.021, 0.0, D),
        (0.97, 0.0, D),  # below counts as above
        (1.005, 0.005, A),  # 1.96 errors reach 1.0148
        (1.015, 0.005, I),  # reaches 1.0248
        (1.04, 0.005, D),  # reaches down to 1.030
        (1.0, 0.5, I),  # pure noise never agrees
    ],
)
def test_the_whole_interval_decides(value: float, error: float, word: Verdict) -> None:
    assert judged(value, error, 0.02).verdict is word


def test_the_tolerance_is_what_is_still_allowed() -> None:
    assert judged(1.125, 0.0, 0.125).verdict is A  # binary fractions, so that the edge is hit exactly


def test_few_degrees_of_freedom_widen_the_interval() -> None:
    one = judged(1.0, 0.001, 0.02, dof=1).interval
    assert one.high == pytest.approx(0.001 * math.tan(0.95 * math.pi / 2), rel=1e-9)  # Student at 1 dof is Cauchy
    assert judged(1.0, 0.001, 0.02).interval.high == pytest.approx(0.001 * 1.9599639845, rel=1e-9)


def test_the_sample_factor_decides_when_it_is_granted() -> None:
    doubtful = judged(1.015, 0.005, 0.02)
    assert doubtful.sample_factor is not None
    assert judged(1.015, 0.005 / math.sqrt(doubtful.sample_factor * 1.001), 0.02).verdict is A
    assert judged(1.015, 0.005 / math.sqrt(doubtful.sample_factor * 0.9), 0.02).verdict is I


def test_no_number_of_samples_moves_a_value_off_the_edge() -> None:
    edge = judged(1.02, 0.001, 0.02)
    assert edge.verdict is I and edge.sample_factor is None and "no number" in edge.reason


def test_a_suite_of_clean_comparisons_raises_its_stated_share_of_alarms() -> None:
    """Draw suites whose true difference sits on the edge of the tolerance, the worst clean case, and count alarms."""
    rate, comparisons, suites = 0.05, 40, 4000
    level = sidak(rate, comparisons).level
    rng = np.random.default_rng(7)
    values = 1.02 + 0.004 * rng.standard_normal((suites, comparisons))
    quantile = stats.norm.isf((1 - level) / 2)
    # Decide one suite through the code; the rest by the same inequality, which that suite confirms.
    alarms = values - 1.0 - quantile * 0.004 > 0.02
    assert [judged(v, 0.004, 0.02, level).verdict is D for v in values[0]] == alarms[0].tolist()
    share = alarms.any(axis=1).mean()
    # Only one side of the interval can alarm at the edge, so the rate is half of the stated one: an upper bound.
    assert share <= rate + 3 * math.sqrt(rate * (1 - rate) / suites)
    assert share >= rate / 2 - 4 * math.sqrt(rate / suites)


def test_sidak_gives_back_the_rate_of_the_suite() -> None:
    for comparisons in (1, 7, 1000, 10**7):
        shared = sidak(0.01, comparisons)
        assert -math.expm1(comparisons * math.log(shared.level)) == pytest.approx(0.01, rel=1e-6)
    with pytest.raises(ValueError, match="between 0 and 1"):
        sidak(0.0, 3)


def test_one_deviation_outweighs_every_doubt_and_one_doubt_every_agreement() -> None:
    assert overall([A, I, D]) is D
    assert overall([A, I, None]) is I
    assert overall([A, A]) is A
    assert overall([None]) is None
