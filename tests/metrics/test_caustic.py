"""Caustic metrics on Gaussian spots whose flux, place and radii are known in closed form."""

import numpy as np
import pytest

from tests.metrics.synthetic import noisy, patch_of, spot, value_of
from vitrail.metrics.caustic import (
    caustic_area,
    caustic_centroid,
    caustic_flux,
    caustic_rings,
    profile_correlation,
)
from vitrail.metrics.caustic_radii import caustic_radii
from vitrail.metrics.measurement import Context, MetricError

CONTEXT = Context()
CENTRED = Context(centre_m=(0.0, 0.0), background=(0.0, 0.0, 0.0))


def test_flux_of_a_known_spot():
    found = caustic_flux(patch_of(spot(power=2.5, colour=(1.0, 0.5, 0.0))), None, CENTRED)
    # The tails beyond 6.7 sigma hold 1e-10.
    np.testing.assert_allclose([m.value for m in found], [2.5, 1.25, 0.0], rtol=1e-8, atol=1e-12)
    assert {m.unit for m in found} == {"W sr^-1"}


def test_flux_within_a_circle_only():
    # 1 - exp(-r^2 / 2 sigma^2) of the spot is within r; a circle over tiles is ragged by 1e-3.
    context = Context(background=(0.0, 0.0, 0.0), centre_m=(0.0, 0.0), outer_radius_m=0.4)
    found = caustic_flux(patch_of(spot()), None, context)
    assert found[0].value == pytest.approx(1 - np.exp(-(0.4**2) / 0.045), rel=1e-3)
    assert caustic_radii(patch_of(spot()), None, context)[1].value < 0.4
    # Light beyond the circle moves nothing.
    lit = patch_of(lambda u, v: spot()(u, v) + 3.0 * (u > 0.6)[..., None])
    assert caustic_flux(lit, None, context)[0].value == pytest.approx(found[0].value, rel=1e-12)
    assert caustic_centroid(lit, None, context)[0].value == pytest.approx(0.0, abs=1e-12)
    with pytest.raises(MetricError, match="centre"):
        caustic_flux(patch_of(spot()), None, Context(outer_radius_m=0.2))


def test_one_percent_of_flux_lost_is_one_percent():
    found = caustic_flux(patch_of(spot(power=0.99)), patch_of(spot()), CONTEXT)
    assert [m.metric for m in found] == ["flux_ratio.red", "flux_ratio.green", "flux_ratio.blue"]
    np.testing.assert_allclose([m.value for m in found], 0.99, rtol=1e-12)


def test_a_lost_caustic_is_far_from_one_on_either_side_and_one_lost_in_both_is_an_error():
    dark = patch_of(lambda u, v: 0 * u * v)
    assert caustic_flux(dark, patch_of(spot()), CENTRED)[0].value == pytest.approx(1e-6)
    assert caustic_flux(patch_of(spot()), dark, CENTRED)[0].value == pytest.approx(1e6)
    with pytest.raises(MetricError, match="neither"):
        caustic_flux(dark, dark, CENTRED)


def test_a_channel_without_light_has_no_ratio():
    red = patch_of(spot(colour=(1.0, 0.0, 0.0)))
    assert [m.metric for m in caustic_flux(red, red, CENTRED)] == ["flux_ratio.red"]


def test_three_millimetres_are_three_millimetres():
    # Cells are 31 mm: a tenth of a cell is measured.
    found = caustic_centroid(patch_of(spot(u0=0.003)), patch_of(spot()), CONTEXT)
    assert value_of(found, "centroid_shift.u") == pytest.approx(0.003, abs=2e-6)
    assert value_of(found, "centroid_shift.v") == pytest.approx(0.0, abs=1e-12)
    assert found[0].parts["distance"] == pytest.approx(0.003, abs=2e-6)


def test_the_centroid_of_one_image_is_in_metres_from_the_patch_centre():
    found = caustic_centroid(patch_of(spot(u0=0.1, v0=-0.2)), None, CENTRED)
    assert (value_of(found, "centroid.u"), value_of(found, "centroid.v")) == pytest.approx((0.1, -0.2), abs=1e-6)


def test_radii_of_a_gaussian():
    # Encircled flux 1 - exp(-r^2 / 2 sigma^2): r50 = 1.17741 sigma, r90 = 2.14597 sigma. The average over a cell of
    # edge h adds h^2 / 12 to sigma^2, and counting the cell as a tile adds as much again: .007 of it here.
    # A circle over tiles is ragged by a hundredth of a cell, 1e-3 of a radius of six cells.
    sigma, cell = 0.15, 2 / 64
    wide = np.sqrt(sigma**2 + cell**2 / 6)
    found = caustic_radii(patch_of(spot()), None, CENTRED)
    assert value_of(found, "r50") == pytest.approx(np.sqrt(2 * np.log(2)) * wide, rel=1.5e-3)
    assert value_of(found, "r90") == pytest.approx(np.sqrt(2 * np.log(10)) * wide, rel=1.5e-3)
    assert found[0].settings["outer_radius_m"] == pytest.approx(1.0)


def test_a_spot_five_percent_wider_is_seen_as_that():
    found = caustic_radii(patch_of(spot(sigma=0.21)), patch_of(spot(sigma=0.2)), CENTRED)
    # The same cells are in both, so the ratio is a little below 1.05: sqrt of (.0441 + h^2/6) / (.04 + h^2/6).
    np.testing.assert_allclose([m.value for m in found], 1.0498, rtol=1.2e-3)


def test_rings_of_a_gaussian():
    edges = (0.0, 0.1, 0.2, 0.4)
    found = caustic_rings(patch_of(spot(), n_u=256, n_v=256), None, Context(centre_m=(0, 0), annulus_edges_m=edges))
    a, b = np.array(edges[:-1]), np.array(edges[1:])
    truth = (np.exp(-(a**2) / 0.045) - np.exp(-(b**2) / 0.045)) / (np.pi * (b**2 - a**2))
    np.testing.assert_allclose([m.value for m in found], truth, rtol=3e-3)
    assert [m.metric for m in found] == ["annulus_mean.0", "annulus_mean.1", "annulus_mean.2"]
    assert caustic_rings(patch_of(spot()), None, CONTEXT) == []


def test_ring_ratios_and_a_ring_off_the_patch():
    context = Context(centre_m=(0, 0), annulus_edges_m=(0.0, 0.1, 0.3))
    found = caustic_rings(patch_of(spot(power=1.02)), patch_of(spot()), context)
    np.testing.assert_allclose([m.value for m in found], 1.02, rtol=1e-12)
    with pytest.raises(MetricError, match="annulus"):
        caustic_rings(patch_of(spot()), None, Context(centre_m=(0, 0), annulus_edges_m=(2.0, 3.0)))


def test_area_above_a_threshold():
    # The spot is above a third of its peak within r^2 = 2 sigma^2 ln 3.
    peak = 1 / (2 * np.pi * 0.15**2)
    found = caustic_area(patch_of(spot(), n_u=200, n_v=200), None, Context(threshold_radiance=peak / 3))
    # The ramp of +-10 % of the threshold is symmetric in radiance, and nearly so in area.
    assert found[0].value == pytest.approx(np.pi * 2 * 0.15**2 * np.log(3), rel=5e-3)
    assert found[0].unit == "m^2"


def test_area_ratio_of_a_wider_spot():
    # Same power, 10 % wider, threshold low: the area hardly changes; same height, 10 % wider: 21 %.
    wide = patch_of(spot(sigma=0.165, power=1.21), n_u=200, n_v=200)
    narrow = patch_of(spot(sigma=0.15), n_u=200, n_v=200)
    found = caustic_area(wide, narrow, CONTEXT)[0]
    assert found.value == pytest.approx(1.21, rel=5e-3)
    assert found.settings["threshold"] == pytest.approx(2 * narrow.values.mean())


def test_correlation_sees_shape_and_not_brightness():
    dim, moved = patch_of(spot(power=0.3)), patch_of(spot(u0=0.15))
    for m in profile_correlation(dim, patch_of(spot()), CONTEXT):
        assert m.value == pytest.approx(1.0, abs=1e-12)
    by_name = {m.metric: m.value for m in profile_correlation(moved, patch_of(spot()), CONTEXT)}
    assert by_name["profile_correlation.u"] < 0.8
    assert by_name["profile_correlation.v"] == pytest.approx(1.0, abs=1e-6)


def test_a_direction_without_shape_is_left_out_and_one_that_lost_its_shape_is_not():
    bar = patch_of(lambda u, v: np.exp(-((u / 0.2) ** 2)) + 0 * v)
    even = patch_of(lambda u, v: 1 + 0 * u + 0 * v)
    first, second = noisy(bar, 0.05, 1), noisy(bar, 0.05, 2)
    assert [m.metric for m in profile_correlation(first, second, CONTEXT)] == ["profile_correlation.u"]
    lost = profile_correlation(noisy(even, 0.05, 3), second, CONTEXT)
    assert [m.metric for m in lost] == ["profile_correlation.u"] and lost[0].value < 0.8


def test_shape_metrics_do_not_see_exposure_and_flux_does_not_see_shape():
    bright, plain = patch_of(spot(power=3.0)), patch_of(spot())
    for m in (*caustic_centroid(bright, plain, CONTEXT), *caustic_radii(bright, plain, CONTEXT)):
        assert m.value == pytest.approx(m.ideal, abs=1e-9)
    wide = patch_of(spot(sigma=0.1))
    np.testing.assert_allclose([m.value for m in caustic_flux(wide, plain, CONTEXT)], 1.0, rtol=1e-6)


def test_light_comes_from_the_layer_and_not_from_the_floor():
    lit = patch_of(lambda u, v: 1 + spot()(u, v), layers={"caustic": spot(), "diffusion": lambda u, v: 1 + 0 * u * v})
    found = caustic_flux(lit, None, CONTEXT)
    assert found[0].value == pytest.approx(1.0, rel=1e-8)
    assert found[0].settings["light"] == "layer caustic"


def test_one_image_without_layers_is_read_with_the_others_background():
    def floor(u, v):
        return 0.5 * (np.hypot(u, v) > 0.5)[..., None] * np.ones(3)

    layers = {"caustic": spot(), "diffusion": floor}
    ours = patch_of(lambda u, v: floor(u, v) + spot()(u, v), layers=layers)
    theirs = patch_of(lambda u, v: floor(u, v) + 1.1 * spot()(u, v))
    found = caustic_flux(ours, theirs, CONTEXT)
    np.testing.assert_allclose([m.value for m in found], 1 / 1.1, rtol=1e-8)
    assert "taken off both" in found[0].caveats[0]


def test_a_known_background_is_taken_off():
    lit = patch_of(lambda u, v: 0.25 + spot()(u, v))
    found = caustic_flux(lit, None, Context(background=(0.25, 0.25, 0.25)))
    np.testing.assert_allclose([m.value for m in found], 1.0, rtol=1e-8)
    assert any("counts" in caveat for caveat in caustic_flux(lit, None, CONTEXT)[0].caveats)
