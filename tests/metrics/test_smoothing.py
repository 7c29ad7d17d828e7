"""What disc, pixel and cell do to a number, found by doing it once more."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.metrics.synthetic import patch_of, spot
from vitrail.metrics.smoothing import gathered_again, pixelled_again, smoothed_again

SIGMA = 0.15


@pytest.mark.parametrize("radius_m", [0.0, 0.05, 0.1])
def test_a_gaussian_spot_grows_by_the_variance_of_disc_pixel_and_cell(radius_m: float) -> None:
    samples = patch_of(spot(sigma=SIGMA))
    again = smoothed_again(samples, radius_m)
    spread = radius_m**2 / 4 + samples.cell_u_m**2 / 6
    for seen, more in ((samples, 0.0), (again, spread)):
        light = seen.values[..., 0] / seen.values[..., 0].sum()
        # A cell is the mean of what it covers, which alone adds width^2 / 12.
        expected = SIGMA**2 + samples.cell_u_m**2 / 12 + more
        assert (light * samples.u_m[None, :] ** 2).sum() == pytest.approx(expected, rel=1e-4)
        assert (light * samples.v_m[:, None] ** 2).sum() == pytest.approx(expected, rel=1e-4)


def test_no_light_is_lost_not_even_at_the_edges() -> None:
    samples = patch_of(spot(u0=0.95, sigma=SIGMA))
    assert smoothed_again(samples, 0.1).values.sum() == pytest.approx(samples.values.sum(), rel=1e-12)


def test_the_second_smoothing_changes_the_top_of_a_spot_nearly_as_much_as_the_first() -> None:
    radius_m = 0.06
    sharp = spot(sigma=SIGMA)(np.zeros(1), np.zeros(1))[0, 0]
    once = smoothed_again(patch_of(spot(sigma=SIGMA), n_u=255, n_v=255), radius_m)
    twice = smoothed_again(once, radius_m)
    first, second = (sharp - once.values.max()) / sharp, (once.values.max() - twice.values.max()) / sharp
    # Each multiplies the variance: the second change is smaller by two widths, 4 % each, squared of the plane.
    assert first == pytest.approx(0.04, rel=0.1)
    assert second == pytest.approx(first, rel=0.1)


def test_the_disc_spreads_gathered_light_alone_and_pixels_all_of_it() -> None:
    light, rest = patch_of(spot(sigma=SIGMA)).values, patch_of(spot(u0=0.3, sigma=SIGMA)).values
    samples = replace(patch_of(spot(sigma=SIGMA)), values=light + rest, layers={"caustic": light, "diffusion": rest})
    disc, pixel = gathered_again(samples, 0.1), pixelled_again(samples)
    np.testing.assert_array_equal(disc.layers["diffusion"], rest)
    for again in (disc, pixel):
        assert again.layers["caustic"].max() < light.max()
        np.testing.assert_allclose(sum(again.layers.values()), again.values, atol=1e-12)
    assert pixel.layers["diffusion"].max() < rest.max()
    # Disc after pixels is what smooths everything that is gathered.
    caustic = replace(samples, values=light, layers={"caustic": light})
    both = gathered_again(pixelled_again(caustic), 0.1)
    np.testing.assert_allclose(both.values, smoothed_again(caustic, 0.1).values, atol=1e-12)
