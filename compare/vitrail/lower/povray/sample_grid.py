"""Where the two half images sample a pixel: grids of two shapes, so that both see an edge, at other places.

POV-Ray samples on the grid of one picture, ``across`` times as wide and ``down`` times as high as what is asked for.
Both grids are centred: each averages a gradient exactly, and it shows in neither. Opposite shifts would make it noise
that cancels in the mean, fifty times too much on a caustic. An edge across n columns is off by up to 1/2n of its step,
and in the other half, across columns without a common factor with n, by another amount. Over all places of an edge the
two errors have nothing in common, and half their difference is the error of their mean. Edges along a diagonal meet
n m different places of such a grid, 2 n - 1 of a square one.

Measured on checks behind a lens, against 481 samples a pixel: error of the mean and half the difference of the halves
are 0.054 and 0.051 with 5 samples, 0.023 and 0.025 with 16. With the same square grid for both halves they were 0.045
and 0.009 with twice 4, 0.018 and 0.009 with twice 16.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import count


@dataclass(frozen=True)
class SampleGrid:
    """Samples of a pixel from left to right, and from top to bottom."""

    across: int
    down: int

    @property
    def samples(self) -> int:
        return self.across * self.down


def half_grids(samples: int) -> dict[str, SampleGrid]:
    """The grids of both halves, which have ``samples`` a pixel together, or a few more; one is the middle for both.

    5, 16, 27, 48, 65, 108, ...: m + 1 columns in m rows, and m columns in the next number of rows but one that has no
    common factor with m. The grids are no mirror images, which would err alike along a diagonal.
    """
    if samples == 1:
        return {"a": SampleGrid(1, 1), "b": SampleGrid(1, 1)}
    shorter = next(m for m in count(1) if m * (m + 1 + _rows(m)) >= samples)
    return {"a": SampleGrid(shorter + 1, shorter), "b": SampleGrid(shorter, _rows(shorter))}


def _rows(columns: int) -> int:
    return next(rows for rows in count(columns + 2) if math.gcd(rows, columns) == 1)
