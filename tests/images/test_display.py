"""The display transform is fixed, monotone, and that of sRGB; false colours mean what their scale says."""

import numpy as np
import pytest

from vitrail.images.display import Display, luminance, srgb
from vitrail.images.false_colour import COLD, HEAT, HOT, NEUTRAL, heat, signed_difference


def test_known_points_of_the_srgb_curve():
    # 18 % grey is 0.4613 and 0.5 is 0.7354 in sRGB (IEC 61966-2-1, to the digits commonly printed).
    np.testing.assert_allclose(srgb(np.array([0.0, 0.18, 0.5, 1.0])), [0.0, 0.4613, 0.7354, 1.0], atol=6e-5)


def test_the_curve_joins_its_two_pieces():
    below, above = srgb(np.array([0.0031308 * (1 - 1e-9), 0.0031308 * (1 + 1e-9)]))
    # The standard's own constants leave a step of 1e-8.
    assert above - below == pytest.approx(0, abs=1e-7)


def test_one_stop_is_a_factor_of_two():
    radiance = np.linspace(0, 0.5, 20).reshape(1, -1, 1).repeat(3, 2)
    np.testing.assert_array_equal(Display(exposure_stops=1).apply(radiance), Display().apply(2 * radiance))
    np.testing.assert_array_equal(Display(white=4).apply(radiance), Display(exposure_stops=-2).apply(radiance))


def test_the_transform_never_looks_at_the_image():
    radiance = np.random.default_rng(2).random((5, 5, 3)) * 0.5
    brighter = radiance.copy()
    brighter[0, 0] = 1e6
    np.testing.assert_array_equal(Display().apply(radiance)[1:], Display().apply(brighter)[1:])


def test_nan_is_not_shown():
    with pytest.raises(ValueError, match="gate"):
        Display().apply(np.full((1, 1, 3), np.nan))


def test_settings_are_all_there():
    expected = {"display_exposure_stops": 2.0, "display_white": 1.0, "display_curve": "srgb"}
    assert Display(exposure_stops=2.0).settings() == expected


def test_luminance_of_white_is_one():
    assert luminance(np.ones(3)) == pytest.approx(1.0, rel=1e-15)


def test_signed_difference_has_a_scale():
    reference = np.zeros((1, 3, 3))
    candidate = np.array([[[-0.2] * 3, [0.0] * 3, [0.1] * 3]])
    picture = signed_difference(candidate, reference, scale=0.1)
    np.testing.assert_allclose(picture[0], [COLD, NEUTRAL, HOT], atol=1e-12)
    with pytest.raises(ValueError, match="above 0"):
        signed_difference(candidate, reference, scale=0.0)


def test_heat_grows_in_luminance():
    picture = heat(np.linspace(-1, 2, 50), low=0.0, high=1.0)
    assert (np.diff(luminance(picture)) >= -1e-12).all()
    np.testing.assert_array_equal(picture[[0, -1]], HEAT[[0, -1]])
    with pytest.raises(ValueError, match="upwards"):
        heat(np.zeros((2, 2)), low=1.0, high=1.0)
