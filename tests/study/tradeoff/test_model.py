"""The model finds the law behind samples that follow one, chooses by it, and knows where it ends."""

from __future__ import annotations

import math

import pytest

from vitrail.study.statistics import Estimate
from vitrail.study.tradeoff.model import best_for_budget, best_for_error, series_of
from vitrail.study.tradeoff.records import TriedSetting


def _known(value: float) -> Estimate:
    return Estimate(value=value, low=value, high=value)


def _settings(
    radius: float, bias: float, noise: float, start_s: float = 0.1, per_photon_s: float = 1e-6
) -> list[TriedSetting]:
    """Samples of cost = start + photons * per_photon_s and error^2 = bias^2 + noise^2 / photons."""
    return [
        TriedSetting(
            label=f"{n} photons",
            knobs={"photons": n, "gather_radius_m": radius},
            cost_s=_known(start_s + per_photon_s * n),
            error=_known(math.hypot(bias, noise / math.sqrt(n))),
            bias=bias,
            standard_deviation=noise,
            on_front=False,
            at_knee=False,
            peak_memory_bytes=None,
            runs=1,
        )
        for n in (10_000, 100_000, 1_000_000)
    ]


WIDE, NARROW = _settings(0.02, bias=0.01, noise=1.0), _settings(0.01, bias=0.001, noise=4.0)


def test_the_law_is_found() -> None:
    (law,) = series_of(WIDE)
    assert law.start_s == pytest.approx(0.1) and law.per_unit_s == pytest.approx(1e-6)
    assert math.sqrt(law.bias_squared) == pytest.approx(0.01) and law.variance == pytest.approx(1.0)
    assert (law.least, law.most) == (1e4, 1e6)


def test_a_coarse_target_takes_the_wide_disc_and_a_fine_one_the_narrow() -> None:
    laws = series_of([*WIDE, *NARROW])
    # 2 %: the wide disc needs 1 / (0.02^2 - 0.01^2) = 3334 photons, fewer than were tried, so the least tried.
    coarse = best_for_error(laws, 0.02)
    assert coarse.knobs == {"photons": 10_000, "gather_radius_m": 0.02}
    # 0.5 % is below the wide disc's bias; the narrow one needs 16 / (0.005^2 - 0.001^2) photons.
    fine = best_for_error(laws, 0.005)
    assert fine.knobs["gather_radius_m"] == 0.01
    assert fine.knobs["photons"] == pytest.approx(16 / (0.005**2 - 0.001**2), rel=1e-6)
    assert fine.cost_s == pytest.approx(0.1 + 1e-6 * fine.knobs["photons"]) and fine.error <= 0.005


def test_what_is_out_of_reach_is_not_promised() -> None:
    laws = series_of([*WIDE, *NARROW])
    assert best_for_error(laws, 0.0005) is None  # below every bias
    assert best_for_error(laws, 0.0015) is None  # would need 13 million photons, four times the most tried is 4
    assert best_for_budget(laws, 0.05) is None  # less than starting costs


def test_a_budget_is_spent_and_not_exceeded() -> None:
    found = best_for_budget(series_of([*WIDE, *NARROW]), 0.6)
    assert found.knobs["photons"] == pytest.approx(500_000, abs=1)
    assert found.cost_s <= 0.6
    # 500 000 photons: wide 1 % bias and 0.14 % noise, narrow 0.1 % and 0.57 %.
    assert found.knobs["gather_radius_m"] == 0.01


def test_two_settings_teach_nothing() -> None:
    assert series_of(WIDE[:2]) == []
