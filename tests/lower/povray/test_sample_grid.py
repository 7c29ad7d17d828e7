"""Where the halves sample a pixel: no gradient shows in their difference, and every edge does, as large as it errs."""

from __future__ import annotations

import math

import numpy as np
import pytest

from vitrail.lower.povray.sample_grid import SampleGrid, half_grids

pytestmark = pytest.mark.fast


@pytest.mark.parametrize("samples", [2, 3, 4, 5, 6, 16, 17, 64, 100, 1000, 2**20])
def test_both_halves_together_have_the_samples_asked_for(samples: int) -> None:
    """Up to 2.7 times as many in the worst case, 6 instead of 16; from 100 on at most half as many again."""
    first, second = half_grids(samples).values()
    assert samples <= first.samples + second.samples <= (2.7 if samples < 100 else 1.5) * samples
    for one, other in ((first.across, second.across), (first.down, second.down), (first.across, first.down)):
        assert math.gcd(one, other) == 1 and one != other


def test_one_sample_is_the_middle_of_the_pixel_in_both_halves() -> None:
    assert half_grids(1) == {"a": SampleGrid(1, 1), "b": SampleGrid(1, 1)}


def seen(grid: SampleGrid, picture: object) -> np.ndarray:
    """The mean over a grid of a function of x and y in [0, 1]."""
    x, y = (np.arange(grid.across) + 0.5) / grid.across, (np.arange(grid.down) + 0.5) / grid.down
    return picture(*np.meshgrid(x, y)).mean()  # type: ignore[operator]


@pytest.mark.parametrize("samples", [4, 16, 64])
def test_a_gradient_is_exact_in_each_half(samples: int) -> None:
    for grid in half_grids(samples).values():
        assert seen(grid, lambda x, y: 3 * x - 2 * y) == pytest.approx(0.5, abs=1e-12)


@pytest.mark.parametrize("samples", [4, 16, 64])
@pytest.mark.parametrize("degrees", [0, 20, 45, 90])
def test_half_the_difference_is_the_error_of_the_mean_at_an_edge(samples: int, degrees: float) -> None:
    """Over all places of an edge, 4000 of them. Within a half: where an edge cuts a corner, both halves err alike."""
    along = np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])
    fine = SampleGrid(97, 89)
    difference, error = [], []
    for place in np.random.default_rng(1).uniform(0, 1, 4000) * along.sum():
        a, b, true = (
            seen(grid, lambda x, y: x * along[0] + y * along[1] < place)  # noqa: B023
            for grid in (*half_grids(samples).values(), fine)
        )
        difference.append((a - b) / 2)
        error.append((a + b) / 2 - true)
    told, real = (float(np.sqrt(np.mean(np.square(each)))) for each in (difference, error))
    assert 2 / 3 < told / real < 3 / 2
