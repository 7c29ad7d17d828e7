"""Seed and radius of a pass: functions of its number, and as Knaus and Zwicker have them."""

from __future__ import annotations

import math

import pytest

from tests.pipeline.passes.small_job import ball_lens
from vitrail.base.changed import changed
from vitrail.pipeline.job import prepare
from vitrail.pipeline.passes.schedule import (
    blur_radius_m,
    gather_radii_m,
    lowered_pass,
    pass_settings,
    seed_of_pass,
    square_radii,
)
from vitrail.plan.settings import Quality
from vitrail.scene.model import Image


def test_square_radii_are_a_quotient_of_gamma_functions() -> None:
    """The product of (k + 2/3) / (k + 1) up to i - 1 is Gamma(i + 2/3) / (Gamma(5/3) Gamma(i + 1))."""
    squares = square_radii(1000)
    for i in (1, 2, 7, 100, 1000):
        gammas = math.lgamma(i + 2 / 3) - math.lgamma(5 / 3) - math.lgamma(i + 1)
        # A thousand roundings, and logarithms of up to 5900 with 16 digits.
        assert squares[i - 1] == pytest.approx(math.exp(gammas), rel=1e-11)


def test_the_blur_of_the_mean_goes_to_nothing_as_the_third_root() -> None:
    """Mean of i^(-1/3) / Gamma(5/3) up to N: 3/2 N^(-1/3) / Gamma(5/3), but for terms of 1/N to its 2/3."""
    passes = 100_000
    law = 1.5 / math.gamma(5 / 3) * passes ** (-1 / 3)
    assert blur_radius_m(2.0, passes) ** 2 == pytest.approx(4 * law, rel=passes ** (-2 / 3))
    assert gather_radii_m(2.0, 3) == pytest.approx([2.0, 2 * math.sqrt(5 / 6), 2 * math.sqrt(5 / 6 * 8 / 9)])


def test_the_first_pass_is_the_plain_rendering_and_no_other_shares_its_seed() -> None:
    lowered = {"title": "ball", "settings": {"seed": 1, "gather_radius_m": 0.1, "photons": 10}}
    assert lowered_pass(lowered, 1) == lowered
    second = lowered_pass(lowered, 2)["settings"]
    assert second["photons"] == 10 and second["gather_radius_m"] < 0.1
    seeds = {seed_of_pass(seed, number) for seed in (1, 2, 3) for number in range(1, 200)}
    assert len(seeds) == 3 * 199 and max(seeds) < 2**63


def test_a_pass_has_two_samples_unless_the_scene_wants_one() -> None:
    ready = prepare(ball_lens(8), Quality.DRAFT)
    scene, draft = ready.scene, ready.settings
    assert draft.samples == 1
    assert pass_settings(scene, draft, samples_given=False) == changed(draft, samples=2)
    with pytest.raises(ValueError, match="ask for 2 samples or more"):
        pass_settings(scene, draft, samples_given=True)
    pixels = scene.model_copy(update={"image": Image(width=8, height=8, samples=1)})
    assert pass_settings(pixels, draft, samples_given=False) == draft
