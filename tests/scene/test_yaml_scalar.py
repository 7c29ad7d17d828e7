"""Plain words by YAML 1.2's core schema, with its differences from 1.1."""

from __future__ import annotations

import math

import pytest

from vitrail.scene.yaml_scalar import TooLarge, plain_value

MEANING = [
    ("", None), ("~", None), ("null", None), ("true", True), ("FALSE", False),
    ("12", 12), ("-7", -7), ("+3", 3), ("0x1F", 31), ("0o17", 15), ("010", 10),
    ("1.", 1.0), (".5", 0.5), ("-1.5e-3", -0.0015), ("1e3", 1000.0), ("18446744073709551616", 2.0**64),
    ("18446744073709551615", 2**64 - 1),
    (".inf", math.inf), ("-.INF", -math.inf),
    # Words that YAML 1.1 reads as booleans or in base 60, and 1.2 as text.
    ("yes", "yes"), ("off", "off"), ("1:30", "1:30"), ("nan", "nan"), ("1_000", "1_000"), ("0b1", "0b1"), ("e3", "e3"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "value"), MEANING)
def test_what_a_word_means(text: str, value: object) -> None:
    found = plain_value(text)
    assert found == value and type(found) is type(value)


def test_not_a_number() -> None:
    found = plain_value(".nan")
    assert isinstance(found, float) and math.isnan(found)


@pytest.mark.parametrize("text", ["1e309", "-1e400", "9" * 310, "9" * 100_000, "0x" + "f" * 300, "1" * 500 + ".5"])
def test_numbers_beyond_double_precision(text: str) -> None:
    with pytest.raises(TooLarge):
        plain_value(text)
