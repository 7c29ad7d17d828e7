"""Analysis of a trade-off on rows whose answer is known by construction."""

from __future__ import annotations

import math

import numpy as np
import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.pipeline.task import Row
from vitrail.study.tradeoff.analysis import TARGETS, analyse_rows
from vitrail.study.tradeoff.records import FailedTask, Price, Tradeoff
from vitrail.study.tradeoff.sentence import sentence


def analysed(rows: list[Row]) -> Tradeoff:
    return analyse_rows(rows, "spot", "A spot")


def _row(engine: str, photons: int, seed: int, error: float, cost: float, doubt: float = 0.0) -> Row:
    spec = {"engine": engine, "settings": {"photons": photons}, "wishes": {}, "seed": seed}
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
    found = analysed(ROWS).phenomena[Phenomenon.CAUSTIC]
    (order,) = found.engines["tracer"].orders
    # Photons 1, 2, 3 stand for costs of 0.1, 1 and 10 s: the slope is that of the least squares through three points.
    slope = np.polyfit(np.log([1, 2, 3]), np.log([0.1, 1.0, 10.0]), 1)[0]
    assert order.along == "photons" and order.settings == 3
    assert order.cost.value == pytest.approx(slope, rel=1e-9)
    assert order.error.value == pytest.approx(-slope / 2, rel=1e-9)
    # 5 % is reached where 0.1 sqrt(0.1 / t) = 0.05, at 0.4 s; POV-Ray at 4 s.
    five = found.equal_error[0]
    assert (five.tracer.status, five.tracer.cpu_s) == ("reached", pytest.approx(0.4))
    assert (five.povray.status, five.povray.cpu_s) == ("reached", pytest.approx(4.0))
    assert five.povray_over_tracer == pytest.approx(10)
    assert found.equal_error[2].tracer.status == "not_reached"  # 0.1 % would need 1000 s
    assert found.sentence.startswith("An error of 5 %, 1 % and 0.1 % in the caustic costs the tracer 0.4 CPU s")
    assert found.sentence.endswith("not reached.")


def test_seeds_are_one_setting_and_bias_is_apart_from_spread() -> None:
    rows = [_row("tracer", 1, 1, 0.02, 1.0), _row("tracer", 1, 2, 0.04, 3.0)]
    (setting,) = analysed(rows).phenomena[Phenomenon.CAUSTIC].engines["tracer"].settings
    assert [setting.cost_s.value, setting.cost_s.low, setting.cost_s.high] == [1.0, 1.0, 3.0]
    assert setting.error.value == pytest.approx(math.sqrt((0.02**2 + 0.04**2) / 2))
    assert setting.bias == pytest.approx(0.03)
    assert setting.standard_deviation == pytest.approx(0.02 / math.sqrt(2))


def test_the_interval_comes_from_the_noise_of_the_errors() -> None:
    quiet, noisy = (
        analysed([_row("tracer", 1, 1, 0.02, 1.0, doubt)]).phenomena[Phenomenon.CAUSTIC].engines["tracer"]
        for doubt in (0.0, 0.01)
    )
    assert quiet.settings[0].error.high == pytest.approx(0.02)
    assert noisy.settings[0].error.high > 0.025


def test_a_failed_row_is_listed_and_not_counted() -> None:
    failed = Row("x", "setting", {"engine": "povray", "settings": {}, "wishes": {}, "seed": 1}, failure="it crashed")
    found = analysed([*ROWS, failed])
    assert found.failures == (FailedTask(spec=dict(failed.spec), failure="it crashed"),)
    assert found.phenomena == analysed(ROWS).phenomena


def _prices(**prices: tuple[str, float | None]) -> dict[str, Price]:
    targets = {"five": "0.05", "one": "0.01", "tenth": "0.001"}
    return {targets[name]: Price(status=s, cpu_s=cpu) for name, (s, cpu) in prices.items()}


def test_the_sentence_says_what_is_a_price_what_a_limit_and_what_is_not_reached() -> None:
    tracer = _prices(five=("at_most", 0.5), one=("reached", 12.3), tenth=("not_reached", None))
    povray = _prices(five=("at_most", 2.0), one=("at_most", 2.0), tenth=("at_most", 2.0))
    assert sentence("indirect_light", {"tracer": tracer, "povray": povray}, TARGETS, None) == (
        "An error of 5 %, 1 % and 0.1 % in the indirect light costs the tracer at most 0.5 CPU s, 12 CPU s and"
        " not reached; POV-Ray at most 2 CPU s each."
    )


def test_a_cheapest_setting_that_is_good_enough_is_an_upper_limit_of_the_price() -> None:
    rows = [_row("tracer", n, 1, error, cost) for n, error, cost in ((1, 0.03, 0.2), (2, 0.004, 0.8))]
    prices = analysed(rows).phenomena[Phenomenon.CAUSTIC].engines["tracer"].price_s
    assert prices["0.05"] == Price(status="at_most", cpu_s=0.2)
    assert prices["0.01"].status == "reached"


def test_no_price_is_stated_below_the_error_of_the_reference_itself() -> None:
    own = Row("r", "reference", {"engine": "tracer"}, _row("tracer", 1, 1, 0.02, 1.0).result)
    found = analysed([own, *ROWS]).phenomena[Phenomenon.CAUSTIC]
    assert found.reference_error == pytest.approx(0.02)
    prices = found.engines["tracer"].price_s
    assert [prices[str(target)].status for target in TARGETS] == ["reached", "below_reference", "below_reference"]
    assert found.sentence.endswith("against a rendering that is itself known to 2 %.")


def test_runs_that_give_one_image_are_one_sample_of_its_error() -> None:
    once = [_row("povray", 1, 1, 0.02, 1.0, doubt=0.01)]
    thrice = [_row("povray", 1, seed, 0.02, cost, doubt=0.01) for seed, cost in ((1, 0.9), (2, 1.0), (3, 1.1))]
    one, three = (analysed(rows).phenomena[Phenomenon.CAUSTIC].engines["povray"].settings[0] for rows in (once, thrice))
    assert three.error == one.error
    assert (three.cost_s.value, three.cost_s.high, three.runs) == (0.9, 1.1, 3)


def test_the_memory_is_the_most_of_any_run() -> None:
    rows = [_row("tracer", 1, seed, 0.02, 1.0) for seed in (1, 2)]
    rows[1].cost["peak_memory_bytes"] = 7.0
    assert analysed(rows).phenomena[Phenomenon.CAUSTIC].engines["tracer"].settings[0].peak_memory_bytes == 7.0
