"""The only door through which text reaches a POV-Ray scene: numbers, fixed words and generated identifiers.

No name, title or path of a scene file ever becomes scene text [P 8.5]. Every number is checked, because POV-Ray reads
``1e400`` as infinity without a word [P 12.20], and every block is built from the fixed words written in this package.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from vitrail.base.vector import Vec

FLOAT32_LIMIT = 3.0e38
"""Colours and photon positions are single precision in POV-Ray; nothing larger may be written."""


class UnwritableNumber(ValueError):
    """A number that POV-Ray would silently turn into infinity or refuse."""


def number(value: float) -> str:
    """The shortest decimal that reads back as the same double; zero has no sign."""
    if not math.isfinite(value) or abs(value) > FLOAT32_LIMIT:
        raise UnwritableNumber(f"{value!r} cannot be written as a POV-Ray number")
    text = repr(float(value) + 0.0)
    return text[:-2] if text.endswith(".0") else text


def vector(value: Sequence[float]) -> str:
    return "<" + ", ".join(number(each) for each in value) + ">"


def rgb(colour: Sequence[float]) -> str:
    """A linear colour; one number where the channels are equal."""
    if colour[0] == colour[1] == colour[2]:
        return f"rgb {number(colour[0])}"
    return f"rgb {vector(colour)}"


def matrix(axes: tuple[Vec, Vec, Vec], origin: Vec) -> str:
    """world = x axes[0] + y axes[1] + z axes[2] + origin, as POV-Ray's row-vector matrix."""
    return "matrix " + vector([*axes[0], *axes[1], *axes[2], *origin])


def block(head: str, parts: Iterable[str]) -> str:
    """``head { parts }`` on one line where it is short, else one part a line, indented."""
    listed = [part for part in parts if part]
    line = f"{head} {{ {' '.join(listed)} }}"
    if len(line) <= 100 and "\n" not in line:
        return line
    inner = "\n".join("  " + row for part in listed for row in part.split("\n"))
    return f"{head} {{\n{inner}\n}}"
