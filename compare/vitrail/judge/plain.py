"""Settings and parts of a measurement as JSON can hold them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np


def plain(mapping: Mapping[str, Any]) -> dict[str, Any]:
    """Arrays become lists, numpy numbers become numbers, mappings and tuples are walked through."""
    return {str(key): _value(value) for key, value in mapping.items()}


def _value(value: Any) -> Any:
    if isinstance(value, Mapping):
        return plain(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, list | tuple):
        return [_value(item) for item in value]
    return value
