"""The bisection finds a limit that is known, from either side, and says so when there is none."""

from __future__ import annotations

import math

import pytest

from vitrail.study.extremes.search import SHARPNESS, Reading, binary, find_limit, walk, whole


@pytest.mark.parametrize(("start", "factor", "limit"), [(1.0, 10.0, 3.3e4), (1.0, 0.1, 2.7e-5)])
def test_a_known_limit_is_bracketed(start: float, factor: float, limit: float) -> None:
    def probe(value: float) -> Reading:
        good = value < limit if factor > 1 else value > limit
        return Reading(value, 1.0 if good else 0.0, 1.0, 0.01)

    found = find_limit(walk(start, factor, 9), probe)
    low, high = sorted((found.last_holding, found.first_failing))
    assert low <= limit <= high
    assert high / low <= SHARPNESS


def test_whole_numbers_are_found_exactly() -> None:
    found = find_limit(walk(1, 2, 9), lambda n: Reading(n, n if n <= 126 else 0, n, 0.0), whole)
    assert (found.last_holding, found.first_failing) == (126, 127)


@pytest.mark.parametrize(("factor", "limit"), [(2.0**13, 2.0**129), (2.0**-13, 2.0**-125)])
def test_powers_of_two_stay_powers_of_two(factor: float, limit: float) -> None:
    tried: list[float] = []

    def probe(value: float) -> Reading:
        tried.append(value)
        good = value <= limit if factor > 1 else value >= limit
        return Reading(value, 1.0 if good else 0.0, 1.0, 0.0)

    found = find_limit(walk(1.0, factor, 11), probe, binary)
    assert all(math.frexp(value)[0] == 0.5 for value in tried)
    assert found.last_holding == limit
    assert found.first_failing == limit * (2 if factor > 1 else 0.5)


def test_no_failure_and_failure_at_once() -> None:
    assert find_limit([1.0, 2.0], lambda v: Reading(v, v, v, 0.0)).first_failing is None
    at_once = find_limit([1.0, 2.0], lambda v: Reading(v, math.nan, v, 1.0))
    assert (at_once.last_holding, at_once.first_failing) == (None, 1.0)
