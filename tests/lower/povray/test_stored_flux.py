"""What 8 bits cut off photons behind panes of several tints, and the factor that keeps them above a step."""

from __future__ import annotations

import numpy as np
import pytest

from tests.lower.povray.real_povray import LOOKING_DOWN, SUN, lowered, rendered, scene
from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.certificate.certificate import HALF_FLOAT
from vitrail.lower.povray.photons.stored_flux import ONE_STEP, best_mantissa_factor, stored_loss, worst_loss

pytestmark = pytest.mark.povray

TINTS = (0.81, 0.9025, 0.01, 0.5625)
"""t^2 of the panes of figure 4, in one channel."""


def test_a_stored_flux_has_eight_bits_cut_off_below() -> None:
    assert stored_loss(255 / 256) == 0
    assert stored_loss(180 / 256 * 2.0**-9) == 0
    assert stored_loss(128.999 / 256) == pytest.approx(0.999 / 128.999)
    assert max(stored_loss(flux) for flux in np.geomspace(0.01, 100, 100_000)) == pytest.approx(ONE_STEP, rel=0.01)


@pytest.mark.parametrize("fluxes", [(0.64,), (0.9025, 0.01), TINTS])
def test_the_best_factor_loses_less_than_any_of_many_tried(fluxes: tuple[float, ...]) -> None:
    factor, loss = best_mantissa_factor(fluxes)
    assert 1 <= factor < 2
    assert loss == worst_loss(fluxes, factor)
    tried = min(worst_loss(fluxes, each) for each in np.geomspace(1, 2, 20_001))
    # 2e-6 is by how much every flux is lifted over its step.
    assert loss <= max(tried, 2.1e-6)


def panes(second: str) -> str:
    """Two tinted panes over a floor seen from below them, side by side or one over the other."""
    return scene(
        "floor: {diffuse: 0.8}\nfirst: {transmission: [0.95, 0.9, 0.5], ior: 1.5}\n"
        "other: {transmission: [0.75, 0.35, 0.9], ior: 1.5}",
        "- {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: floor}\n"
        "- {name: left, box: {min: [-1, 1.5, -1], max: [0, 1.6, 1]}, material: first}\n"
        f"- {{name: right, box: {second}, material: other}}\n",
        SUN,
        LOOKING_DOWN,
    )


BESIDE = "{min: [0.01, 1.5, -1], max: [1.01, 1.6, 1]}"
BELOW = "{min: [-1, 1.2, -1], max: [0, 1.3, 1]}"


def colour_entry(text: str) -> float:
    made = lowered(text, photons=30_000)
    return sum(
        each.residual for each in made.certificate.of(Phenomenon.COLOURED_TRANSMISSION) if str(each.item) == "photons"
    )


def test_panes_beside_each_other_lose_what_the_certificate_states_and_no_more() -> None:
    stated = colour_entry(panes(BESIDE))
    assert 0 < stated < 1e-3
    image = rendered(panes(BESIDE), photons=200_000).image.radiance
    for columns, tint in ((slice(2, 13), (0.95, 0.9, 0.5)), (slice(20, 30), (0.75, 0.35, 0.9))):
        seen = image[4:28, columns].mean(axis=(0, 1)) / 0.8
        # Jittered photons leave 1e-3 of noise in such a mean; one step would cost up to 7.8e-3.
        assert seen == pytest.approx(np.square(tint), rel=stated + 1.5e-3)


def test_light_through_both_panes_has_a_flux_of_its_own() -> None:
    assert colour_entry(panes(BELOW)) == ONE_STEP


def test_what_rounds_the_image_counts_as_often_as_the_whole_is_larger_than_the_light() -> None:
    certificate = lowered(panes(BESIDE), photons=30_000).certificate
    once, thrice = (certificate.bound(Phenomenon.CAUSTIC, whole) for whole in (1.0, 3.0))
    assert thrice - once == pytest.approx(2 * HALF_FLOAT)


def test_the_factor_for_one_tint_would_cost_the_others_half_a_percent() -> None:
    assert worst_loss(TINTS, 255 / 256 / max(TINTS)) > 0.004
    assert best_mantissa_factor(TINTS)[1] < 0.001
