"""Global metrics against other laboratories' numbers and against the traps that they are known for."""

import numpy as np
import pytest

from vitrail.images.display import Display
from vitrail.images.exr import ImageLayers
from vitrail.metrics.colour_difference import WHITE, XYZ_OF_RGB, chromaticity, delta_e_2000, lab
from vitrail.metrics.errors import colour_error, relative_l1, relative_mse
from vitrail.metrics.flip import FlipSettings, flip, flip_map
from vitrail.metrics.measurement import MetricError
from vitrail.metrics.ssim import SCALE_WEIGHTS, multi_scale_ssim, ssim
from vitrail.metrics.whole_image import WHOLE_IMAGE, measure_image

PLAIN = Display()


def scene(height=192, width=208, seed=5):
    """A picture with edges, gradients and texture, between 0 and 1.2."""
    y, x = np.mgrid[0:height, 0:width]
    base = 0.4 + 0.3 * np.sin(x / 17) * np.cos(y / 11) + 0.4 * ((x // 32 + y // 32) % 2)
    return (
        np.stack([base, base * 0.8, base[::-1] * 0.6], axis=-1)
        + np.random.default_rng(seed).random((height, width, 3)) / 20
    )


@pytest.mark.parametrize("metric", WHOLE_IMAGE, ids=lambda m: m.__name__)
def test_equal_images_are_ideal(metric):
    measured = metric(scene(), scene(), PLAIN)
    assert measured.value == pytest.approx(measured.ideal, abs=1e-7)


@pytest.mark.parametrize("metric", WHOLE_IMAGE, ids=lambda m: m.__name__)
def test_a_change_is_seen_and_nan_and_sizes_are_refused(metric):
    worse = metric(scene() * 1.3, scene(), PLAIN)
    assert abs(worse.value - worse.ideal) > 1e-3
    with pytest.raises(MetricError, match="size"):
        metric(scene()[:-1], scene(), PLAIN)
    holed = scene()
    holed[3, 4, 1] = np.nan
    with pytest.raises(MetricError, match="NaN"):
        metric(holed, scene(), PLAIN)


@pytest.mark.parametrize("metric", [ssim, multi_scale_ssim, flip], ids=lambda m: m.__name__)
def test_scaling_light_and_exposure_together_changes_nothing(metric):
    dark = metric(scene() * 1.3 / 8, scene() / 8, Display(exposure_stops=3.0))
    assert dark.value == pytest.approx(metric(scene() * 1.3, scene(), PLAIN).value, abs=2e-6)


def test_ssim_is_that_of_its_definition_on_a_constant_shift():
    # Flat images a and b have no variance: SSIM = (2ab + C1) / (a^2 + b^2 + C1), with display values a and b.
    flat = np.full((32, 32, 3), 0.2)
    a, b = PLAIN.apply(np.array([0.2, 0.3]))
    truth = (2 * a * b + 1e-4) / (a * a + b * b + 1e-4)
    assert ssim(flat * 1.5, flat, PLAIN).value == pytest.approx(truth, rel=1e-9)


def test_data_range_is_that_of_the_display_and_is_stated():
    measured = ssim(scene() * 0.01, scene() * 0.011, PLAIN)
    assert measured.settings["data_range"] == 1.0
    assert measured.settings["display_exposure_stops"] == 0.0
    # A guessed range (that of the image) would call these nearly black pictures very different.
    assert measured.value > 0.9


def test_multi_scale_on_flat_images_is_luminance_of_the_last_scale():
    # Contrast and structure of flat images are 1, so only (luminance) ^ weight of the coarsest scale is left.
    flat = np.full((192, 192, 3), 0.2)
    one = ssim(flat * 1.5, flat, PLAIN).value
    many = multi_scale_ssim(flat * 1.5, flat, PLAIN)
    assert many.value == pytest.approx(one ** (SCALE_WEIGHTS[-1] / sum(SCALE_WEIGHTS)), rel=1e-9)
    assert len(many.parts["scales"]) == 5 and not many.caveats


def test_multi_scale_forgives_what_single_scale_does_not():
    noise = np.random.default_rng(0).normal(size=scene().shape) * 0.1
    assert multi_scale_ssim(scene() + noise, scene(), PLAIN).value > ssim(scene() + noise, scene(), PLAIN).value


def test_a_small_image_says_how_many_scales_it_has_room_for():
    measured = multi_scale_ssim(scene(48, 48), scene(48, 48), PLAIN)
    assert "3 of 5 scales" in measured.caveats[0]
    assert sum(measured.settings["scale_weights"]) == pytest.approx(1.0)
    with pytest.raises(MetricError, match="at least 11"):
        ssim(scene(8, 40), scene(8, 40), PLAIN)


def rendered_twice(base, sigma, seed):
    draw = np.random.default_rng(seed)
    a, b = (base + draw.normal(size=base.shape) * sigma * np.sqrt(2) for _ in range(2))
    return ImageLayers((a + b) / 2, a, b)


@pytest.mark.parametrize("sigma", [0.02, 0.1])
def test_floors_are_what_two_equal_renderings_read(sigma):
    # Two unbiased renderings of one gradient differ by noise alone: SSIM .1 at noise .1 is the published trap.
    base = np.linspace(0.2, 0.8, 96)[None, :, None] * np.ones((96, 1, 3))
    for measured in measure_image(rendered_twice(base, sigma, 1), rendered_twice(base, sigma, 2), PLAIN):
        # 28,000 values: a draw scatters by 2 %; the laws of scale (SSIM, clipping at white) are good to a tenth.
        departure, floor = abs(measured.value - measured.ideal), abs(measured.floor - measured.ideal)
        assert floor == pytest.approx(departure, rel=0.12), measured.metric


def test_ssim_of_noise_alone_is_low():
    base = np.linspace(0.2, 0.8, 96)[None, :, None] * np.ones((96, 1, 3))
    measured = measure_image(rendered_twice(base, 0.1, 1), rendered_twice(base, 0.1, 2), PLAIN)[0]
    assert measured.metric == "ssim" and measured.value < 0.2


def test_without_halves_there_is_no_floor():
    measured = measure_image(ImageLayers(scene()), ImageLayers(scene()), PLAIN)
    assert [m.metric for m in measured] == ["ssim", "ms_ssim", "flip", "relmse", "relative_l1", "delta_e_2000"]
    assert all(m.floor is None and "half images" in m.caveats[-1] for m in measured)


def test_flip_exposures_are_never_automatic():
    # On a black background the automatic ones move by 16 stops; ours are the scene's whatever the picture.
    black = np.zeros((64, 64, 3))
    black[20:24, 20:24] = 5.0
    for picture in (scene(64, 64), black):
        used = flip(picture * 1.1, picture, Display(exposure_stops=1.0)).settings
        assert (used["start_exposure"], used["stop_exposure"], used["exposures"]) == (-1.0, 3.0, 5)
    with pytest.raises(MetricError, match="two exposures"):
        flip_map(black, black, FlipSettings(0.0, 0.0, 1))


def test_flip_shows_where():
    changed = scene(64, 64)
    changed[40:50, 10:20] *= 1.5
    errors = flip_map(changed, scene(64, 64), FlipSettings.around(PLAIN))
    assert errors.shape == (64, 64)
    row, column = np.unravel_index(np.argmax(errors), errors.shape)
    # FLIP spreads an error over the width of its filters, a few pixels at 67 pixels per degree.
    assert 36 <= row < 54 and 6 <= column < 24
    assert errors[:20, 40:].max() < 1e-6


def test_negative_radiance_is_said_aloud():
    picture = scene(64, 64) - 0.3
    assert "negative" in flip(picture, picture, PLAIN).caveats[0]


def test_relative_mse_and_l1_of_a_known_factor():
    flat = np.full((8, 8, 3), 0.5)
    # (0.05)^2 / (0.25 + 0.01)
    assert relative_mse(flat * 1.1, flat, PLAIN).value == pytest.approx(0.0025 / 0.26, rel=1e-12)
    # Light and exposure scaled together change nothing, the epsilon included.
    dim = relative_mse(flat * 1.1 / 8, flat / 8, Display(exposure_stops=3.0))
    assert dim.value == pytest.approx(0.0025 / 0.26, rel=1e-12)
    assert relative_l1(flat * 1.1, flat, PLAIN).value == pytest.approx(0.1, rel=1e-12)
    with pytest.raises(MetricError, match="black"):
        relative_l1(flat, flat * 0, PLAIN)


def test_lab_of_known_colours():
    # D65 white, 18 % grey (L* = 49.496), and linear red: L* a* b* of sRGB red is 53.24, 80.09, 67.20.
    found = lab(np.array([[1.0, 1.0, 1.0], [0.18, 0.18, 0.18], [1.0, 0.0, 0.0]]))
    np.testing.assert_allclose(found[0], [100, 0, 0], atol=1e-9)
    assert found[1][0] == pytest.approx(49.496, abs=1e-3)
    np.testing.assert_allclose(found[2], [53.24, 80.09, 67.20], atol=0.02)
    # Below (6 / 29)^3 lightness is 903.3 Y, and the two parts of the curve meet there.
    assert lab(np.full(3, 0.004))[0] == pytest.approx(24389 / 27 * 0.004, rel=1e-12)
    low, high = lab(np.full((2, 3), (6 / 29) ** 3) * np.array([[1 - 1e-9], [1 + 1e-9]]))[:, 0]
    assert high == pytest.approx(low, abs=1e-6)


@pytest.mark.parametrize(
    ("first", "second", "truth"),
    [
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, 2.5, 0.0), (50.0, 0.0, -2.5), 4.3065),
        ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
        ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
        ((22.7233, 20.0904, -46.6940), (23.0331, 14.9730, -42.5619), 2.0373),
        ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
    ],
)
def test_ciede2000_against_the_published_pairs(first, second, truth):
    # Sharma, Wu, Dalal 2005, Color Res. Appl. 30(1), table 1: pairs 1, 14, 17, 25, 30, 34.
    assert float(delta_e_2000(np.array(first), np.array(second))) == pytest.approx(truth, abs=5e-5)


def test_colour_error_of_a_known_pair():
    # 18 % grey against 0.2 grey: a difference of lightness alone.
    low, high = np.full((8, 8, 3), 0.18), np.full((8, 8, 3), 0.2)
    truth = float(delta_e_2000(lab(low[0, 0]), lab(high[0, 0])))
    assert colour_error(low, high, PLAIN).value == pytest.approx(truth, rel=1e-12)
    assert colour_error(low / 4, high / 4, Display(exposure_stops=2.0)).value == pytest.approx(truth, rel=1e-12)


def test_a_vanished_caustic_leaves_ssim_high():
    # The reason for metrics by phenomenon: the caustic is a small part of the picture.
    full = np.full((192, 192, 3), 0.3)
    full[90:102, 90:102] = 3.0
    lost = np.full((192, 192, 3), 0.3)
    assert ssim(lost, full, PLAIN).value > 0.95


def test_cie_colours_are_those_of_colour_science():
    import colour

    rgb = np.random.default_rng(4).random((50, 3)) * 1.5
    xyz = rgb @ XYZ_OF_RGB.T
    white = colour.XYZ_to_xy(WHITE)
    # Both are formulas in doubles: what differs is rounding, of numbers up to 100.
    np.testing.assert_allclose(lab(rgb), colour.XYZ_to_Lab(xyz, white), atol=1e-12 * 100)
    uv = colour.Luv_to_uv(colour.XYZ_to_Luv(xyz, white), white)
    np.testing.assert_allclose(chromaticity(rgb), uv, atol=1e-12)
