"""Roughness and shadow on edges of known blur and width."""

import numpy as np
import pytest
from scipy.special import ndtr

from tests.metrics.synthetic import noisy, patch_of, value_of
from vitrail.metrics.measurement import Context, MetricError
from vitrail.metrics.roughness import blur, blur_near, contrast, contrast_near
from vitrail.metrics.shadow import penumbra

CELL = 2 / 64
CONTEXT = Context(along="u")


def blurred(sigma, place=0.0, dark=0.1, lit=0.9):
    return patch_of(lambda u, v: dark + (lit - dark) * ndtr((u - place) / sigma) + 0 * v)


def ramp(width, place=0.0, dark=0.0, lit=1.0):
    return patch_of(lambda u, v: dark + (lit - dark) * np.clip((u - place) / width + 0.5, 0, 1) + 0 * v, n_u=128)


@pytest.mark.parametrize("sigma", [0.01, 0.05, 0.2])
@pytest.mark.parametrize("place", [0.0, 0.013])
def test_a_known_blur_is_found_whatever_the_cell(sigma, place):
    # 0.01 is a third of a cell: the model averages over cells as the picture does. The picture's 8 points a cell lack
    # h^2 / 12 / 64 of that average's variance, 1.3e-6 m^2 or 0.64 % of the smallest blur.
    assert value_of(blur(blurred(sigma, place), None, CONTEXT), "blur") == pytest.approx(sigma, rel=8e-3)


def test_a_sharp_edge_has_no_blur():
    sharp = patch_of(lambda u, v: 1.0 * (u > 0.3 * CELL / 0.3) + 0 * v)
    assert value_of(blur(sharp, None, CONTEXT), "blur") < 0.05 * CELL


def test_blur_in_degrees_of_the_throw():
    found = blur(blurred(0.05), None, Context(along="u", throw_m=2.0))
    assert value_of(found, "blur_deg") == pytest.approx(np.degrees(np.arctan(0.025)), rel=5e-3)


def test_blur_ratio_sees_neither_exposure_nor_place():
    found = blur(blurred(0.06, place=0.02, dark=0.3, lit=2.7), blurred(0.05), CONTEXT)
    assert value_of(found, "blur_ratio") == pytest.approx(1.2, rel=5e-3)


def test_blur_against_a_sharp_reference_is_a_length():
    sharp = patch_of(lambda u, v: 1.0 * (u > 0) + 0 * v)
    found = blur(blurred(0.05), sharp, CONTEXT)
    assert value_of(found, "blur_shift") == pytest.approx(0.05, rel=2e-2)


def test_no_edge_is_an_error():
    with pytest.raises(MetricError, match="no edge"):
        blur(patch_of(lambda u, v: 1 + 0 * u * v), None, CONTEXT)
    with pytest.raises(MetricError, match="no edge"):
        penumbra(patch_of(lambda u, v: 1 + 0 * u * v), None, CONTEXT)


def test_contrast_of_a_sine():
    waves = patch_of(lambda u, v: 1 + 0.9 * np.sin(2 * np.pi * u / 2) + 0 * v)
    # A sine of amplitude a about 1 has a standard deviation of a / sqrt(2); the mean of a sixteenth takes off 0.6 %.
    assert value_of(contrast(waves, None, CONTEXT), "contrast") == pytest.approx(0.9 / np.sqrt(2), rel=1e-2)
    half = patch_of(lambda u, v: 3 + 1.35 * np.sin(2 * np.pi * u / 2) + 0 * v)
    assert value_of(contrast(half, waves, CONTEXT), "contrast_ratio") == pytest.approx(0.5, rel=1e-9)


def test_little_contrast_is_compared_as_a_difference():
    """Behind rough glass 2 % are left: twice as much is 2 % of full contrast, and no deviation by a factor of two."""
    faint, fainter = (patch_of(lambda u, v, a=a: 1 + a * np.sin(np.pi * u) + 0 * v) for a in (0.04, 0.02))
    (found,) = contrast(faint, fainter, CONTEXT)
    assert (found.metric, found.ideal) == ("contrast_shift", 0.0)
    assert found.value == pytest.approx(0.02 / np.sqrt(2), rel=1e-2)


def test_noise_does_not_change_the_form_of_a_comparison():
    """A reference on the limit of contrast, and one on the limit of sharpness: near images keep the form of theirs."""
    high, low = (patch_of(lambda u, v, a=a: 1 + a * np.sin(np.pi * u) + 0 * v) for a in (0.712, 0.711))
    assert value_of(contrast(high, high, CONTEXT), "contrast_ratio") == 1
    assert value_of(contrast(low, low, CONTEXT), "contrast_shift") == 0
    assert value_of(contrast_near(high, high, CONTEXT)(low, low, CONTEXT), "contrast_ratio") == 1
    assert value_of(contrast_near(low, low, CONTEXT)(high, high, CONTEXT), "contrast_shift") == 0
    sharp, soft = (patch_of(lambda u, v, s=s: ndtr(u / s) + 0 * v) for s in (1e-6, 0.3 * CELL))
    assert value_of(blur_near(soft, soft, CONTEXT)(sharp, soft, CONTEXT), "blur_ratio") < 0.1
    assert value_of(blur_near(soft, sharp, CONTEXT)(soft, soft, CONTEXT), "blur_shift") == 0


def test_grain_on_a_flank_does_not_cut_an_edge_in_two():
    """A wide edge in noise of a hundredth of its step: every picture of it shows the same blur to 3 %."""
    wide = blurred(0.2)
    found = [value_of(blur(noisy(wide, 0.08, seed), None, CONTEXT), "blur") for seed in range(20)]
    assert np.std(found) < 0.03 * 0.2 and np.mean(found) == pytest.approx(0.2, rel=0.02)


def test_an_edge_in_noise_as_large_is_none():
    with pytest.raises(MetricError, match="stands out of its noise"):
        blur(noisy(blurred(0.2, dark=0.5, lit=0.51), 0.2, 1), None, CONTEXT)


def test_blur_past_the_patch_is_left_to_contrast():
    """Of an edge as wide as the patch neither end is seen: its height and its width are not told apart."""
    with pytest.raises(MetricError, match="reaches past"):
        blur(blurred(0.8), None, CONTEXT)


def test_a_linear_penumbra():
    found = penumbra(ramp(0.4, place=0.1), None, CONTEXT)
    assert value_of(found, "penumbra_width") == pytest.approx(0.32, rel=1e-3)
    assert value_of(found, "shadow_edge") == pytest.approx(0.1, abs=1e-4)
    assert value_of(found, "shadow_depth") == pytest.approx(0.0, abs=1e-12)
    grey = penumbra(ramp(0.4, dark=1.0, lit=5.0), None, CONTEXT)
    assert value_of(grey, "shadow_depth") == pytest.approx(0.2, rel=1e-12)


def test_a_falling_edge_is_an_edge_too():
    found = penumbra(patch_of(lambda u, v: 1 - np.clip(u / 0.4 + 0.5, 0, 1) + 0 * v), None, CONTEXT)
    assert value_of(found, "penumbra_width") == pytest.approx(0.32, rel=1e-3)


def test_penumbra_differences():
    found = penumbra(ramp(0.5, 0.02, 0.1), ramp(0.4), CONTEXT)
    assert value_of(found, "penumbra_difference") == pytest.approx(0.08, abs=5e-4)
    assert value_of(found, "shadow_edge_shift") == pytest.approx(0.02, abs=1e-4)
    assert value_of(found, "shadow_depth_shift") == pytest.approx(0.1, abs=1e-6)


def test_penumbra_does_not_see_exposure():
    for m in penumbra(ramp(0.4, lit=5.0), ramp(0.4), CONTEXT):
        assert m.value == pytest.approx(0.0, abs=1e-9)
