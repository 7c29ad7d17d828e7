"""Many numbers as one text of a JSON file: their bytes, lowest first, in base64. No digit is lost."""

from __future__ import annotations

import base64
from typing import Literal

import numpy as np

NumberType = Literal["f8", "f4", "u4"]


def pack(numbers: np.ndarray, type_: NumberType) -> str:
    """The text of an array, row after row: doubles, floats or counts of 32 bits."""
    return base64.b64encode(np.ascontiguousarray(numbers, "<" + type_).tobytes()).decode("ascii")
