"""Radiance for the page: the pixels of an EXR as text in a script, because a page from disk may not fetch.

One script holds one strip of rows of one side: ``VITRAIL.tile("tracer", {...})`` with the values in base64, little
endian, row by row, red green blue. Values are half floats where that loses nothing (POV-Ray writes half), else float32.
"""

from __future__ import annotations

import base64
import json
from pathlib import Path

import numpy as np

STRIP_VALUES = 3_000_000
"""At most this many numbers a script: 12 MB of floats, 16 MB of text, which a browser parses without a stall."""


def write_tiles(folder: Path, side: str, values: np.ndarray) -> list[str]:
    """Write (height, width, channels) as scripts into ``folder``; return their names, first row first."""
    height, width, channels = values.shape
    rows = max(STRIP_VALUES // (width * channels), 1)
    dtype = "<f2" if _fits_half(values) else "<f4"
    names = []
    for strip, first in enumerate(range(0, height, rows)):
        part = np.ascontiguousarray(values[first : first + rows], dtype=dtype)
        head = {
            "width": width,
            "height": height,
            "channels": channels,
            "row": first,
            "rows": part.shape[0],
            "type": dtype,
        }
        head["data"] = base64.b64encode(part.tobytes()).decode("ascii")
        name = f"{side}-{strip}.js"
        (folder / name).write_text(f"VITRAIL.tile({json.dumps(side)}, {json.dumps(head)});\n")
        names.append(name)
    return names


def _fits_half(values: np.ndarray) -> bool:
    """Whether half floats hold exactly what float32 would."""
    single = values.astype(np.float32)
    with np.errstate(over="ignore"):
        return bool(np.array_equal(single.astype(np.float16).astype(np.float32), single))
