"""Analysis of a trade-off on rows whose answer is known by construction."""

from __future__ import annotations

import math

import pytest

from vitrail.study.task import Row
from vitrail.study.tradeoff.analysis import analyse_rows, sentence


def _row(engine: str, photons: int, seed: int, error: float, cost: float, doubt: float = 0.0) -> Row:
    spec = {"engine": engine, "settings": {"photons": photons}, "transport": {}, "seed": seed}
    errors = [
        {"phenomenon": "caustic", "observation": "spot", "metric": name, "error": sign * error, "standard_error": doubt}
        for name, sign in (("r50", 1), ("r90", -1))
    ]
    return Row(f"{engine}-{photons}-{seed}", "setting", spec, {"errors": errors}, None, {"cpu_s": cost})


ROWS = [
    # The tracer's error falls as cost^-1/2 from 10 % at 0.1 s; POV-Ray needs ten times the time for the same.
    *(
        _row("tracer", n, seed, 0.1 * math.sqrt(0.1 / cost), cost)
        for n, cost in ((1, 0.1), (2, 1.0), (3, 10.0))
        for seed in (1, 2)
    ),
    *(_row("povray", n, 1, 0.1 * math.sqrt(1 / cost), cost) for n, cost in ((1, 1.0), (2, 10.0), (3, 100.0))),
]


def test_prices_orders_and_ratios_of_power_laws() -> None:
    found = analyse_rows(ROWS)["phenomena"]["caustic"]
    assert found["engines"]["tracer"]["order"]["value"] == pytest.approx(-0.5, abs=1e-9)
    # 5 % is reached where 0.1 sqrt(0.1 / t) = 0.05, at 0.4 s; POV-Ray at 4 s.
    five = found["equal_error"][0]
    assert (five["tracer"], five["povray"]) == (pytest.approx(0.4), pytest.approx(4.0))
    assert five["povray_over_tracer"] == pytest.approx(10)
    assert found["equal_error"][2]["tracer"] is None  # 0.1 % would need 1000 s
    assert found["sentence"].startswith("An error of 5 %, 1 % and 0.1 % in the caustic costs the tracer 0.4 CPU s")
    assert found["sentence"].endswith("not reached.")


def test_seeds_are_one_setting_and_bias_is_apart_from_spread() -> None:
    rows = [_row("tracer", 1, 1, 0.02, 1.0), _row("tracer", 1, 2, 0.04, 3.0)]
    (setting,) = analyse_rows(rows)["phenomena"]["caustic"]["engines"]["tracer"]["settings"]
    assert setting["cost_s"]["value"] == 2.0
    assert setting["error"]["value"] == pytest.approx(math.sqrt((0.02**2 + 0.04**2) / 2))
    assert setting["bias"] == pytest.approx(0.03)
    assert setting["standard_deviation"] == pytest.approx(0.02 / math.sqrt(2))


def test_the_interval_comes_from_the_noise_of_the_errors() -> None:
    quiet, noisy = (
        analyse_rows([_row("tracer", 1, 1, 0.02, 1.0, doubt)])["phenomena"]["caustic"]["engines"]["tracer"]
        for doubt in (0.0, 0.01)
    )
    assert quiet["settings"][0]["error"]["high"] == pytest.approx(0.02)
    assert noisy["settings"][0]["error"]["high"] > 0.025


def test_a_failed_row_is_listed_and_not_counted() -> None:
    failed = Row("x", "setting", {"engine": "povray", "settings": {}, "transport": {}, "seed": 1}, failure="it crashed")
    found = analyse_rows([*ROWS, failed])
    assert found["failures"] == [{"spec": dict(failed.spec), "failure": "it crashed"}]
    assert found["phenomena"] == analyse_rows(ROWS)["phenomena"]


def test_the_sentence_says_not_reached() -> None:
    engines = {"tracer": {"price_s": {"0.05": 0.5, "0.01": 12.3, "0.001": None}}}
    assert sentence("indirect_light", engines) == (
        "An error of 5 %, 1 % and 0.1 % in the indirect light costs the tracer 0.5 CPU s, 12 CPU s and not reached."
    )
