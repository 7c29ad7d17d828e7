"""What a plain word of YAML means by the core schema of version 1.2: nothing, true or false, a number, or text."""

from __future__ import annotations

import math
import re

MAX_DIGITS = 400
"""Numbers with more characters than this are not converted; the largest finite one has 309 digits."""

_INTEGER = re.compile(r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_NOT_FINITE = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")
_WORDS = {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}
_NULLS = ("", "~", "null", "Null", "NULL")

_EXACT_INTEGERS = 2**64
"""Whole numbers below this stay whole: a stored recipe holds seeds of 64 bits."""


class TooLarge(ValueError):
    """A number beyond the range of double precision."""


def plain_value(text: str) -> None | bool | int | float | str:
    """The value of an unquoted scalar. Raises TooLarge for a number that would read as infinite."""
    if text in _NULLS:
        return None
    if text in _WORDS:
        return _WORDS[text]
    if _NOT_FINITE.fullmatch(text):
        return float(text.replace(".", "", 1))
    if _INTEGER.fullmatch(text):
        return _integer(text)
    if _FLOAT.fullmatch(text):
        return _finite(text)
    return text


def _integer(text: str) -> int | float:
    """An integer as such where programs agree on it, as a float beyond."""
    if len(text) > MAX_DIGITS:
        raise TooLarge(text)
    value = int(text, 0) if text[:2] in ("0x", "0o") else int(text, 10)
    if abs(value) < _EXACT_INTEGERS:
        return value
    try:
        return float(value)
    except OverflowError:
        raise TooLarge(text) from None


def _finite(text: str) -> float:
    value = float(text) if len(text) <= MAX_DIGITS else math.inf
    if math.isinf(value):
        raise TooLarge(text)
    return value
