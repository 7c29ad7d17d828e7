"""Statistics of a trade-off, on data whose answers are known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from vitrail.study.statistics import (
    Estimate,
    Setting,
    convergence_order,
    cost_of_error,
    error_at_cost,
    knee,
    pareto_front,
)


def _setting(label: str, cost: float, error: float) -> Setting:
    price, size = (Estimate(value=value, low=value, high=value) for value in (cost, error))
    return Setting(label=label, cost_s=price, error=size, bias=0.0, standard_deviation=error)


def test_front_keeps_what_nothing_beats() -> None:
    settings = [_setting("a", 1, 0.1), _setting("b", 2, 0.2), _setting("c", 3, 0.05), _setting("d", 3, 0.06)]
    assert [s.label for s in pareto_front(settings)] == ["a", "c"]


def test_knee_is_where_the_front_turns() -> None:
    # Error falls as 1/cost until 10 s and hardly after that: the knee is at 10 s by construction.
    front = [_setting(str(c), c, 1 / c if c <= 10 else 0.1 * (10 / c) ** 0.05) for c in (1, 3, 10, 30, 100)]
    assert knee(front).label == "10"
    straight = [_setting(str(c), c, 1 / c) for c in (1, 10, 100)]
    assert knee(straight) is None


def test_order_of_a_power_law_is_its_exponent() -> None:
    costs = np.array([1, 2, 4, 8, 16.0])
    order = convergence_order(costs, 0.3 * costs**-0.5)
    assert order.value == pytest.approx(-0.5, abs=1e-12)  # exact data: rounding only
    with pytest.raises(ValueError, match="three settings"):
        convergence_order([1, 2], [1, 2])


def test_equal_error_and_equal_time() -> None:
    front = [_setting("a", 1, 0.1), _setting("b", 100, 0.01)]
    # On a log-log line of slope -1/2, an error of 0.0316 costs 10 s.
    assert cost_of_error(front, 0.1 / math.sqrt(10)) == pytest.approx(10, rel=1e-12)
    assert cost_of_error(front, 0.5) == 1
    assert cost_of_error(front, 0.001) is None
    assert error_at_cost(front, 50) == 0.1
    assert error_at_cost(front, 0.5) is None
