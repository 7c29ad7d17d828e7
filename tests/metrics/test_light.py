"""Radiance, evenness, transmission, absorption, indirect light and energy on patches of known light."""

import numpy as np
import pytest

from tests.metrics.synthetic import patch_of, value_of
from vitrail.metrics.absorption import absorption_fit, optical_depth
from vitrail.metrics.diffusion import evenness
from vitrail.metrics.energy import furnace_deviation
from vitrail.metrics.indirect import indirect_light
from vitrail.metrics.measurement import Context, MetricError
from vitrail.metrics.profile import light_of
from vitrail.metrics.radiance import mean_radiance
from vitrail.metrics.transmission import chromaticity_shift, colour_difference, transmittance

CONTEXT = Context(full_radiance=(1.0, 1.0, 1.0))


def flat(*colour):
    return patch_of(lambda u, v: (1 + 0 * u * v)[..., None] * np.array(colour), n_u=12, n_v=10)


def test_mean_radiance_and_its_ratio():
    found = mean_radiance(flat(0.2, 0.5, 0.0), None, CONTEXT)
    np.testing.assert_allclose([m.value for m in found], [0.2, 0.5, 0.0], rtol=1e-12)
    ratio = mean_radiance(flat(0.2, 0.51, 0.0), flat(0.2, 0.5, 0.0), CONTEXT)
    # Blue is dark in both and has no ratio.
    assert {m.metric: pytest.approx(m.value) for m in ratio} == {
        "radiance_ratio.red": 1.0,
        "radiance_ratio.green": 1.02,
    }


def test_light_in_one_image_only_is_far_from_one_and_finite():
    found = mean_radiance(flat(0.0, 0.0, 0.0), flat(0.5, 0.5, 0.5), CONTEXT)
    assert [m.value for m in found] == pytest.approx([1e-6] * 3)
    assert "no light" in found[0].caveats[0]
    assert mean_radiance(flat(0.1, 0, 0), flat(0, 0, 0), CONTEXT)[0].value == pytest.approx(1e6)


def test_evenness_of_a_plane_and_a_bowl():
    found = evenness(patch_of(lambda u, v: 2 + 0.1 * u - 0.3 * v), None, CONTEXT)
    # From u = -1 to 1 the radiance changes by 0.2, a tenth of the mean.
    assert value_of(found, "tilt.u") == pytest.approx(0.1, rel=1e-9)
    assert value_of(found, "tilt.v") == pytest.approx(-0.3, rel=1e-9)
    assert value_of(found, "bow") == pytest.approx(0.0, abs=1e-9)
    bowl = evenness(patch_of(lambda u, v: 1 - 0.06 * (u**2 + v**2)), None, CONTEXT)
    # The mean of the bowl is 1 - .04.
    assert value_of(bowl, "bow") == pytest.approx(0.12 / 0.96, rel=1e-3)


def test_evenness_sees_no_exposure_and_compares_by_difference():
    shifts = evenness(
        patch_of(lambda u, v: 3 * (2 + 0.1 * u + 0 * v)), patch_of(lambda u, v: 2 + 0.1 * u + 0 * v), CONTEXT
    )
    np.testing.assert_allclose([m.value for m in shifts], 0.0, atol=1e-12)
    tilted = evenness(patch_of(lambda u, v: 1 + 0.01 * u + 0 * v), flat(1, 1, 1), CONTEXT)
    assert value_of(tilted, "tilt_shift.u") == pytest.approx(0.02, rel=1e-9)
    with pytest.raises(MetricError, match="black"):
        evenness(flat(0, 0, 0), None, CONTEXT)


def test_transmittance_of_a_pane():
    found = transmittance(flat(0.81, 0.25, 0.04), None, Context(full_radiance=(1.0, 0.5, 0.0)))
    # Blue has no light to begin with.
    assert {m.metric: pytest.approx(m.value) for m in found} == {"transmittance.red": 0.81, "transmittance.green": 0.5}
    assert transmittance(flat(1, 1, 1), None, Context()) == []


def test_chromaticity_of_white_is_that_of_d65():
    found = chromaticity_shift(flat(0.3, 0.3, 0.3), None, CONTEXT)
    # u' = .19784, v' = .46834 of D65 (x, y) = (.3127, .3290): u' = 4x / (-2x + 12y + 3), v' = 9y / (same).
    assert (found[0].value, found[1].value) == pytest.approx((0.19783, 0.46832), abs=1e-5)


def test_a_tint_of_two_percent_moves_colour_and_exposure_does_not():
    tinted = chromaticity_shift(flat(0.5, 0.49, 0.5), flat(0.5, 0.5, 0.5), CONTEXT)
    assert tinted[0].parts["distance"] > 5e-4
    for m in chromaticity_shift(flat(0.9, 0.7, 0.5), flat(0.45, 0.35, 0.25), CONTEXT):
        assert m.value == pytest.approx(0.0, abs=1e-12)
    with pytest.raises(MetricError, match="chromaticity"):
        chromaticity_shift(flat(0, 0, 0), None, CONTEXT)


def test_delta_e_is_zero_for_equals_and_grows_with_tint():
    grey = flat(0.5, 0.5, 0.5)
    assert colour_difference(grey, grey, CONTEXT)[0].value == 0
    assert colour_difference(flat(0.5, 0.49, 0.5), grey, CONTEXT)[0].value > 0.5
    assert colour_difference(grey, None, CONTEXT) == []
    # White is the full radiance: four times the light under four times the white is the same colour.
    bright = colour_difference(flat(2.0, 1.96, 2.0), flat(2.0, 2.0, 2.0), Context(full_radiance=(4.0, 4.0, 4.0)))
    assert bright[0].value == pytest.approx(colour_difference(flat(0.5, 0.49, 0.5), grey, CONTEXT)[0].value, rel=1e-9)


def test_a_known_absorption_per_metre():
    sigma, thickness = np.array([2.0, 0.5, 0.1]), 0.7
    left = np.exp(-sigma * thickness)
    found = optical_depth(flat(*left), None, Context(full_radiance=(1, 1, 1), thickness_m=thickness))
    for channel, truth in zip(("red", "green", "blue"), sigma, strict=True):
        assert value_of(found, f"absorption.{channel}") == pytest.approx(truth, rel=1e-12)
        assert value_of(found, f"optical_depth.{channel}") == pytest.approx(truth * thickness, rel=1e-12)
    assert optical_depth(flat(*left), None, Context()) == []


def test_optical_depth_shift_and_a_black_channel():
    found = optical_depth(flat(0.5 * np.exp(-0.02), 0.5, 0.0), flat(0.5, 0.5, 0.0), CONTEXT)
    assert {m.metric: pytest.approx(m.value) for m in found} == {
        "optical_depth_shift.red": 0.02,
        "optical_depth_shift.green": 0.0,
    }
    with pytest.raises(MetricError, match="no channel"):
        optical_depth(flat(0, 0, 0), flat(1, 1, 1), CONTEXT)


def wedge(sigma, gain=1.0):
    # Thickness 0.5 + 0.2 u metres.
    return patch_of(lambda u, v: gain * np.exp(-np.array(sigma) * (0.5 + 0.2 * u + 0 * v)[..., None]))


def test_a_wedge_gives_the_absorption_whatever_the_light():
    context = Context(along="u", thickness_slope=0.2)
    for gain in (1.0, 0.92):
        found = absorption_fit(wedge((3.0, 1.0, 0.2), gain), None, context)
        # The mean of an exponential over a cell is not that of its logarithm: (sigma h)^2 / 24, below 1e-5 here.
        np.testing.assert_allclose([m.value for m in found], [3.0, 1.0, 0.2], rtol=1e-5)
    shift = absorption_fit(wedge((3.0, 1.0, 0.21)), wedge((3.0, 1.0, 0.2), 0.5), context)
    assert value_of(shift, "absorption_fit_shift.blue") == pytest.approx(0.01, rel=1e-3)
    assert absorption_fit(wedge((3.0, 1.0, 0.2)), None, Context()) == []


def test_a_dark_wedge_is_an_error():
    with pytest.raises(MetricError, match="whole wedge"):
        absorption_fit(flat(0, 0, 0), None, Context(thickness_slope=1.0))


def test_indirect_light_from_its_layer():
    def lit(share):
        return patch_of(
            lambda u, v: 1 + share + 0 * u * v,
            layers={"indirect_light": lambda u, v: share + 0 * u * v, "diffusion": lambda u, v: 1 + 0 * u * v},
        )

    np.testing.assert_allclose([m.value for m in indirect_light(lit(0.1), None, CONTEXT)], 0.1, rtol=1e-12)
    np.testing.assert_allclose([m.value for m in indirect_light(lit(0.11), lit(0.1), CONTEXT)], 1.1, rtol=1e-12)
    with pytest.raises(MetricError, match="neither"):
        indirect_light(lit(0.0), lit(0.0), CONTEXT)


def test_furnace_deviation_has_an_ideal():
    found = furnace_deviation(flat(1.02, 1.0, 0.9), None, Context(furnace_radiance=(1.0, 1.0, 1.0)))
    np.testing.assert_allclose([m.value for m in found], [0.02, 0.0, -0.1], atol=1e-12)
    assert all(m.ideal == 0 for m in found)
    assert furnace_deviation(flat(1, 1, 1), None, CONTEXT) == []


def test_light_that_is_a_difference_knows_how_much_larger_the_whole_was():
    whole, share = patch_of(lambda u, v: 0 * u + 0 * v + 3.0), {"indirect_light": lambda u, v: 0 * u + 0 * v + 1.0}
    layered = patch_of(lambda u, v: 0 * u + 0 * v + 3.0, layers=share)
    ours, theirs = light_of(("indirect_light",), layered, whole, Context())
    assert theirs is not None and theirs.whole_over_light == pytest.approx(3)
    alone, _ = light_of(("indirect_light",), layered, None, Context())
    assert alone.whole_over_light == 1
