"""One way to write JSON: sorted keys, shortest floats that read back the same, one newline at the end."""

from __future__ import annotations

import json
import math
from typing import Any


def canonical_json(value: Any) -> str:
    """Text that is equal whenever the value is; raises ValueError for NaN and infinity."""
    return json.dumps(_plain(value), sort_keys=True, indent=1, allow_nan=False, ensure_ascii=False) + "\n"


def _plain(value: Any) -> Any:
    """Lists for tuples, and +0.0 for -0.0, which prints differently and means the same."""
    match value:
        case dict():
            return {str(key): _plain(item) for key, item in value.items()}
        case list() | tuple():
            return [_plain(item) for item in value]
        case float():
            if not math.isfinite(value):
                raise ValueError(f"{value} cannot be written as JSON")
            return value + 0.0
        case _:
            return value
