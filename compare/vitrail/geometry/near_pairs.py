"""Which of many boxes may touch: by a sweep along one axis, so that the work grows with the pairs that are near."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from vitrail.geometry.bounds import Bounds


def near_pairs(boxes: Sequence[Bounds], slack_m: float = 0.0) -> Iterator[tuple[int, int]]:
    """Pairs (first, second), first < second, of boxes no further apart than ``slack_m``; in ascending order."""
    if not boxes:
        return
    low, high = np.array([box.low for box in boxes], float), np.array([box.high for box in boxes], float)
    axis = _most_spread(low, high)
    order = np.argsort(low[:, axis], kind="stable")
    starts = low[order, axis]
    found = []
    for place, one in enumerate(order):
        # What begins after this box ends is beyond it, and so is all that follows.
        stop = int(np.searchsorted(starts, high[one, axis] + slack_m, side="right"))
        others = order[place + 1 : stop]
        near = np.all((low[others] <= high[one] + slack_m) & (high[others] >= low[one] - slack_m), axis=1)
        found += [(min(int(one), int(other)), max(int(one), int(other))) for other in others[near]]
    yield from sorted(found)


def _most_spread(low: np.ndarray, high: np.ndarray) -> int:
    """The axis along which the finite boxes lie furthest apart."""
    finite = np.isfinite(low).all(axis=1) & np.isfinite(high).all(axis=1)
    return int(np.argmax(np.ptp(low[finite], axis=0))) if finite.any() else 0
