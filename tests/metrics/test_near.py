"""What stands in for a slow metric under noise must give the standard error that the metric itself gives.

Both see the same draws, so 48 draws scatter alike in both; what is left is what the faster form leaves out.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from tests.metrics.synthetic import noisy, patch_of, spot
from vitrail.base.phenomenon import Phenomenon
from vitrail.metrics.by_phenomenon import measure, measure_with_intervals
from vitrail.metrics.caustic_radii import caustic_radii, caustic_radii_near
from vitrail.metrics.displacement import displacement, displacement_near, register
from vitrail.metrics.measurement import Context
from vitrail.metrics.noise import with_interval

pytestmark = pytest.mark.slow

CONTEXT = Context(background=(0.1, 0.1, 0.1))

ALIKE = 0.03
"""What the linear form of a fit may leave out; a standard error from 48 draws is itself good to 10 %."""

ALIKE_IN_RINGS = 0.15
"""Rings are half a cell wide. The metric lays them anew about each centre, which moves by a hundredth of a cell."""


def ball_lens(u, v):
    """A peak and a bright rim, as behind a ball; its flux is spread over the whole patch."""
    away = np.hypot(u, v)
    return 0.1 + 3 * np.exp(-((away / 0.1) ** 2)) + 0.5 * np.exp(-(((away - 0.5) / 0.05) ** 2))


def checker(u, v):
    """Turned checks, as through a magnifier."""
    return 0.5 + 0.3 * np.sign(np.sin(9 * (u + 0.03 * v)) * np.sin(9 * (v - 0.05 * u)))


def moved_checker(u, v):
    return 0.8 * checker(u + 0.043, v - 0.021)


def two_spots(u, v):
    """Light with a hole where its centre is: circles about a moving centre are most sensitive to it."""
    return 0.1 + (spot(-0.4, 0.1, 0.08)(u, v) + spot(0.35, 0.0, 0.12)(u, v))


def counted(light, seed, size, cells=128):
    """A picture with the noise of counted photons."""
    base = patch_of(light, n_u=cells, n_v=cells)
    return noisy(base, size * np.sqrt(base.values.mean(axis=-1, keepdims=True)), seed)


def errors(metric, near, ours, theirs):
    """Standard errors by name of the metric repeated, and of its faster form."""
    plain = with_interval(metric, ours, theirs, CONTEXT)
    faster = with_interval(metric, ours, theirs, CONTEXT, near=near(ours, theirs, CONTEXT))
    assert [each.metric for each in plain] == [each.metric for each in faster]
    assert [each.value for each in plain] == [each.value for each in faster]
    return [
        (p.metric, p.interval.standard_error, f.interval.standard_error) for p, f in zip(plain, faster, strict=True)
    ]


@pytest.mark.parametrize("light", [ball_lens, two_spots])
@pytest.mark.parametrize("size", [0.02, 0.2])
@pytest.mark.parametrize("compared", [False, True])
def test_radii_about_a_moving_centre(light, size, compared):
    ours, theirs = counted(light, 1, size), counted(light, 2, size) if compared else None
    for name, plain, faster in errors(caustic_radii, caustic_radii_near, ours, theirs):
        assert faster == pytest.approx(plain, rel=ALIKE_IN_RINGS), name


@pytest.mark.parametrize("size", [0.01, 0.1, 0.3])
def test_the_place_of_a_pattern(size):
    ours, theirs = counted(moved_checker, 1, size), counted(checker, 2, size)
    for name, plain, faster in errors(displacement, displacement_near, ours, theirs):
        assert faster == pytest.approx(plain, rel=ALIKE), name


def test_a_direction_with_noise_alone_has_no_number():
    stripes = lambda u, v: np.sign(np.sin(9 * u)) + 2.0 + 0 * v  # noqa: E731
    ours, theirs = counted(stripes, 1, 0.1), counted(stripes, 2, 0.1)
    for metric in (displacement, displacement_near(ours, theirs, CONTEXT)):
        assert [found.metric for found in metric(ours, theirs, CONTEXT)] == ["displacement.u"]


def test_a_registration_says_how_each_cell_moves_it():
    ours, theirs = (
        gaussian_filter(counted(light, 1, 0.0, 64).values.mean(axis=-1), 1.0) for light in (moved_checker, checker)
    )
    both = np.array([True, True])
    found = register(ours, theirs, both)
    change = 1e-3 * gaussian_filter(np.random.default_rng(3).standard_normal(ours.shape), 1.0)
    moved = register(ours + change, theirs, both).moved - found.moved
    # Left out is what the residual of the fit has to do with the curvature of the pattern.
    expected = (found.influence * change).sum(axis=(1, 2))
    assert moved == pytest.approx(expected, abs=0.01 * np.abs(expected).max())


@pytest.mark.parametrize("phenomenon", [Phenomenon.CAUSTIC, Phenomenon.REFRACTION])
def test_the_numbers_of_a_phenomenon_are_those_of_its_metrics(phenomenon):
    light = ball_lens if phenomenon is Phenomenon.CAUSTIC else checker
    ours, theirs = counted(light, 1, 0.05, 48), counted(light, 2, 0.05, 48)
    found = measure_with_intervals(phenomenon, ours, theirs, CONTEXT)
    plain = measure(phenomenon, ours, theirs, CONTEXT)
    assert [(each.metric, each.value) for each in found] == [(each.metric, each.value) for each in plain]
    assert all(each.interval is not None for each in found)


def test_what_cannot_be_measured_keeps_its_words():
    dark = replace(counted(ball_lens, 1, 0.05, 32), layers={})
    found = measure_with_intervals(Phenomenon.REFRACTION, dark, dark, Context())
    assert found
