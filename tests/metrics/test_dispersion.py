"""Spectra of known place, order, spread and number of bands."""

import numpy as np
import pytest

from tests.metrics.synthetic import patch_of, value_of
from vitrail.metrics.dispersion import colour_order, spectrum_places, spectrum_spread
from vitrail.metrics.measurement import Context, MetricError

BANDS = {"red": (0.5, 0.0, 0.0), "yellow": (0.5, 0.5, 0.0), "green": (0.0, 0.5, 0.0), "blue": (0.0, 0.0, 1.0)}
"""The paper's four bands at y = 1/2 [O 1.4]; they sum to white."""

CONTEXT = Context(along="u", bands=BANDS, throw_m=2.0)


def spectrum(places=(-0.3, -0.1, 0.1, 0.3), sigma=0.03, power=1.0):
    """One Gaussian line of light a band."""

    def light(u, v):
        lines = np.stack([np.exp(-((u - x) ** 2) / (2 * sigma**2)) + 0 * v for x in places], axis=-1)
        return power * lines @ np.array(list(BANDS.values()))

    return patch_of(light, n_u=128, n_v=16)


def test_bands_are_found_where_they_are():
    found = spectrum_places(spectrum(), None, CONTEXT)
    for name, place in zip(BANDS, (-0.3, -0.1, 0.1, 0.3), strict=True):
        assert value_of(found, f"place.band_{name}") == pytest.approx(place, abs=1e-4)
    # Red is the mean of red and yellow, green that of yellow and green.
    assert value_of(found, "place.red") == pytest.approx(-0.2, abs=1e-6)
    assert value_of(found, "place.green") == pytest.approx(0.0, abs=1e-6)
    assert value_of(found, "place_deg.blue") == pytest.approx(np.degrees(np.arctan(0.15)), abs=1e-4)


def test_spread_in_metres_and_degrees():
    found = spectrum_spread(spectrum(), None, CONTEXT)
    assert value_of(found, "spread") == pytest.approx(0.5, abs=1e-6)
    assert value_of(found, "spread_deg") == pytest.approx(np.degrees(np.arctan(0.15) + np.arctan(0.1)), abs=1e-4)


def test_a_spectrum_squeezed_by_a_tenth():
    squeezed = spectrum(places=(-0.27, -0.09, 0.09, 0.27))
    found = spectrum_spread(squeezed, spectrum(), CONTEXT)
    assert value_of(found, "spread_ratio") == pytest.approx(0.9, abs=1e-5)
    # The width of one line stays, so the whole shrinks a little less.
    assert 0.9 < value_of(found, "rms_width_ratio") < 0.905


def test_a_spectrum_that_moves_as_a_whole_keeps_its_spread():
    moved = spectrum(places=(-0.29, -0.09, 0.11, 0.31))
    assert value_of(spectrum_spread(moved, spectrum(), CONTEXT), "spread_ratio") == pytest.approx(1.0, abs=1e-6)
    for m in spectrum_places(moved, spectrum(), CONTEXT):
        assert m.value == pytest.approx(0.01, abs=1e-4)


def test_reversed_colours_turn_the_sign():
    mirrored = spectrum(places=(0.3, 0.1, -0.1, -0.3))
    assert value_of(spectrum_spread(mirrored, spectrum(), CONTEXT), "spread_ratio") == pytest.approx(-1.0, abs=1e-6)
    assert value_of(colour_order(mirrored, spectrum(), CONTEXT), "colour_order_agreement") == -1
    assert value_of(colour_order(mirrored, None, CONTEXT), "colour_order") == -1


def test_banding_is_counted():
    assert value_of(colour_order(spectrum(), None, CONTEXT), "peaks") == 4
    assert value_of(colour_order(spectrum(sigma=0.2), None, CONTEXT), "peaks") == 1
    # A spot at the very edge of the patch is a spot too.
    assert value_of(colour_order(spectrum(places=(-1.0, -0.1, 0.1, 0.3)), None, CONTEXT), "peaks") == 4
    assert value_of(colour_order(spectrum(sigma=0.2), spectrum(), CONTEXT), "peak_difference") == -3


def test_brightness_is_not_seen():
    found = spectrum_spread(spectrum(power=4.0), spectrum(), CONTEXT)
    np.testing.assert_allclose([m.value for m in found], 1.0, rtol=1e-12)


def test_along_v_too():
    def turned(u, v):
        return np.stack([np.exp(-((v - x) ** 2) / 0.002) + 0 * u for x in (-0.2, 0.0, 0.25)], axis=-1)

    found = spectrum_spread(patch_of(turned, n_u=8, n_v=128), None, Context(along="v"))
    assert value_of(found, "spread") == pytest.approx(0.45, abs=1e-6)


def test_without_a_spectrum_there_is_no_spread():
    grey = patch_of(lambda u, v: np.exp(-(u**2) / 0.01) + 0 * v)
    with pytest.raises(MetricError, match="no spread"):
        spectrum_spread(spectrum(), grey, CONTEXT)
    with pytest.raises(MetricError, match="no red or no blue"):
        spectrum_spread(patch_of(lambda u, v: np.stack([u * 0 + v * 0 + 1, 0 * u * v, 0 * u * v], -1)), None, CONTEXT)
    with pytest.raises(MetricError, match="no light"):
        spectrum_places(patch_of(lambda u, v: 0 * u * v), None, CONTEXT)
