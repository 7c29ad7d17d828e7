"""JSON that is equal text whenever the value is equal: it may be hashed, kept as a key, and compared line by line.

Keys are sorted, floats are the shortest text that reads back the same, NaN and infinity are refused.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any


def canonical_json(value: Any) -> str:
    """The text of a file: each vector or matrix on one line, so that a changed scene changes few lines.

    Raises ValueError for NaN and infinity.
    """
    return _written(value, "\n") + "\n"


def json_line(value: Any) -> str:
    """One line for a journal or a key, in ASCII, without the newline. Raises ValueError for NaN and infinity."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), allow_nan=False)


def _written(value: Any, newline: str) -> str:
    """``value`` as text whose further lines start with ``newline``."""
    deeper = newline + " "
    match value:
        case Mapping():
            lines = [f"{_scalar(str(key))}: {_written(value[key], deeper)}" for key in sorted(value, key=str)]
            return _block("{", lines, "}", newline)
        case list() | tuple():
            if any(_holds_mapping(item) for item in value):
                return _block("[", [_written(item, deeper) for item in value], "]", newline)
            return "[" + ", ".join(_written(item, deeper) for item in value) + "]"
        case _:
            return _scalar(value)


def _block(start: str, lines: list[str], end: str, newline: str) -> str:
    if not lines:
        return start + end
    return start + newline + " " + f",{newline} ".join(lines) + newline + end


def _holds_mapping(value: Any) -> bool:
    match value:
        case Mapping():
            return True
        case list() | tuple():
            return any(_holds_mapping(item) for item in value)
        case _:
            return False


def _scalar(value: Any) -> str:
    """One value; -0.0 prints differently from 0.0 and means the same, so it is written as 0.0."""
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ValueError(f"{value} cannot be written as JSON")
        value = value + 0.0
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
