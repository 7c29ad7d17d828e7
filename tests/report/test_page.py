"""How numbers are written for people."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.report.synthetic import write_run
from vitrail.report.page import confidence, factor, number, quantity, unbroken, words, worst_first


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0, "0"),
        (1.0, "1"),
        (1.30004, "1.3"),
        (-0.0125, "−0.0125"),
        (123456.0, "123\u2009456"),
        (1.5e7, "1.5e7"),
        (2.5e-7, "2.5e−7"),
        (1e7, "1e7"),
        (100.0, "100"),
        (None, "–"),
    ],
)
def test_numbers_keep_four_figures_and_a_true_minus(value: float | None, text: str) -> None:
    assert number(value) == text


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0.0123, "m", "12.3\u202fmm"),
        (-0.0005, "m", "−500\u202fµm"),
        (2.0, "m", "2\u202fm"),
        (0.0, "m", "0\u202fm"),
        (3e-13, "m", "0.0003\u202fnm"),
        (1.2, "1", "1.2"),
        (0.254, "W sr^-1 m^-2", "0.254\u202fW sr⁻¹ m⁻²"),
    ],
)
def test_metres_take_a_prefix_and_units_their_exponents(value: float, unit: str, text: str) -> None:
    assert quantity(value, unit) == text


def test_a_level_is_written_with_enough_nines() -> None:
    assert confidence(0.99) == "99\u202f%"
    assert confidence(0.999163) == "99.916\u202f%"
    assert confidence(0.9999987) == "99.99987\u202f%"


def test_the_sample_factor_never_promises_too_little() -> None:
    assert factor(5.61) == "5.7 times"
    assert factor(1.0) == "1.1 times"


def test_words_of_a_metric_with_a_component() -> None:
    assert words("flux_ratio.red") == "flux ratio, red"


def test_a_number_of_a_sentence_keeps_its_unit_on_the_line() -> None:
    told = "The caustic agrees to within 1.0 %, its place to 0.6 mm (95 %)."
    assert unbroken(told) == "The caustic agrees to within 1.0\u202f%, its place to 0.6\u202fmm (95\u202f%)."
    assert unbroken("2 made of 3 m, 4 mirrors") == "2 made of 3\u202fm, 4 mirrors"


def test_worst_first_goes_by_the_width_of_the_bound_among_what_does_not_deviate(tmp_path: Path) -> None:
    results = write_run(tmp_path)
    alike, apart, unsure, broken = results.scenes
    assert unsure.bound is not None and alike.bound is not None
    closer = alike.model_copy(update={"name": "a", "bound": alike.bound.model_copy(update={"over_tolerance": 0.2})})
    wider = unsure.model_copy(update={"name": "z", "bound": unsure.bound.model_copy(update={"over_tolerance": 9.0})})
    ordered = worst_first([closer, alike, unsure, wider, apart, broken])
    assert [scene.name for scene in ordered] == ["broken", "apart", "z", "unsure", "alike", "a"]
