"""Boxes that may touch: the sweep gives what comparing all pairs gives."""

from itertools import combinations

import numpy as np
import pytest

from vitrail.geometry.bounds import EVERYWHERE, Bounds
from vitrail.geometry.near_pairs import near_pairs


def boxes(count: int, seed: int, size: float) -> list[Bounds]:
    draw = np.random.default_rng(seed)
    low, edge = draw.uniform(-5, 5, (count, 3)), draw.uniform(0, size, (count, 3))
    return [Bounds(tuple(a), tuple(a + b)) for a, b in zip(low.tolist(), edge, strict=True)]


def all_pairs(found: list[Bounds], slack: float) -> list[tuple[int, int]]:
    def near(a: Bounds, b: Bounds) -> bool:
        return all(a.low[k] <= b.high[k] + slack and b.low[k] <= a.high[k] + slack for k in range(3))

    return [(i, j) for i, j in combinations(range(len(found)), 2) if near(found[i], found[j])]


@pytest.mark.parametrize("size", [0.3, 2.0, 8.0])
@pytest.mark.parametrize("slack", [0.0, 0.5])
def test_the_sweep_finds_all_near_pairs_and_no_other(size, slack):
    found = boxes(80, 1, size)
    assert list(near_pairs(found, slack)) == all_pairs(found, slack)


def test_what_is_infinite_is_near_everything():
    half_space = Bounds((-np.inf, -np.inf, -np.inf), (np.inf, 0.0, np.inf))
    found = [*boxes(30, 2, 0.5), half_space, EVERYWHERE]
    assert list(near_pairs(found)) == all_pairs(found, 0.0)
    assert len([pair for pair in near_pairs(found) if 31 in pair]) == 31


def test_boxes_that_share_a_face_are_near():
    one, other = Bounds((0, 0, 0), (1, 1, 1)), Bounds((1, 0, 0), (2, 1, 1))
    assert list(near_pairs([one, other])) == [(0, 1)] and list(near_pairs([])) == []


def test_pairs_far_apart_are_never_looked_at():
    row = [Bounds((float(k), 0, 0), (k + 0.5, 1, 1)) for k in range(3000)]
    # All pairs would be 4.5 million; a sweep that looked at them would not come to an end in a test.
    assert list(near_pairs(row)) == []
