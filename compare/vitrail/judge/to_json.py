"""Settings and parts of a measurement as JSON can hold them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from pydantic import JsonValue


def to_json(mapping: Mapping[str, object]) -> dict[str, JsonValue]:
    """Arrays become lists, numpy numbers become numbers, mappings and tuples are walked through."""
    return {str(key): _value(value) for key, value in mapping.items()}


def _value(value: object) -> JsonValue:
    if isinstance(value, Mapping):
        return to_json(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, list | tuple):
        return [_value(item) for item in value]
    if value is None or isinstance(value, str | bool | int | float):
        return value
    raise TypeError(f"{value!r} is a {type(value).__name__}, which JSON cannot hold")
