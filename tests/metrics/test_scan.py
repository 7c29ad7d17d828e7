"""The scan finds what differs beyond noise, wherever it is, and leaves equal pictures alone at the stated rate."""

import numpy as np
import pytest
from scipy import ndimage, stats

from vitrail.metrics.measurement import MetricError
from vitrail.metrics.scan import FALSE_ALARM_RATE, layer_of, scan

HEIGHT, WIDTH = 90, 120


def scene() -> np.ndarray:
    """A floor with a shadow, a bright caustic beside it and a black corner: four kinds of light with sharp borders."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    light = 0.3 + 0.001 * x
    light = np.where((x > 20) & (x < 60) & (y > 30) & (y < 70), 0.004, light)
    light = light + 5.0 * np.exp(-((x - 70) ** 2 + (y - 50) ** 2) / 18)
    return np.where((x > 100) & (y < 20), 0.0, light)


def rendered(light: np.ndarray, seed: int, size: float = 0.05, disc_px: float = 2.0):
    """A picture (h, w, 3) with its halves: noise of photons counted in discs, and of samples on its own edges."""
    draw = np.random.default_rng(seed)
    reach = int(np.ceil(disc_px))
    disc = np.hypot(*np.mgrid[-reach : reach + 1, -reach : reach + 1]) <= disc_px
    halves = []
    for _ in range(2):
        grain = ndimage.convolve(draw.normal(size=light.shape), disc / np.sqrt(disc.sum()), mode="reflect")
        halves.append(np.repeat((light + size * np.sqrt(2 * light) * grain)[..., None], 3, axis=-1))
    return (halves[0] + halves[1]) / 2, (halves[0], halves[1])


def scanned(first, second, allowed=0.0):
    (ours, own), (theirs, other) = first, second
    return scan(ours, theirs, (own, other), allowed)


def test_equal_pictures_alarm_at_most_at_the_stated_rate():
    pairs = 100
    alarms = sum(bool(scanned(rendered(scene(), 2 * k), rendered(scene(), 2 * k + 1)).regions) for k in range(pairs))
    assert alarms <= stats.binom.ppf(0.999, pairs, FALSE_ALARM_RATE)


def test_a_place_that_is_brighter_is_found_with_its_size():
    brighter = scene()
    brighter[40:60, 30:45] *= 1.7
    found = scanned(rendered(brighter, 1, 0.003), rendered(scene(), 2, 0.003))
    assert len(found.regions) == 1
    region = found.regions[0]
    rows, columns = np.nonzero(region.mask)
    # It is 20 x 15 pixels; noise hides some of its border, and boxes of 5 pixels see two pixels beyond it.
    assert abs(rows.mean() - 49.5) < 2 and abs(columns.mean() - 37) < 2 and 200 <= region.pixels <= 24 * 19
    assert region.candidate / region.reference == pytest.approx(1.7, abs=0.25)
    assert region.excess > found.threshold
    assert abs(found.over_noise[50, 37]) > found.threshold


def test_what_is_allowed_is_no_difference():
    brighter = scene()
    brighter[70:, 60:] *= 1.04
    pair = rendered(brighter, 1, 0.002), rendered(scene(), 2, 0.002)
    assert scanned(*pair, allowed=0.02).regions
    assert not scanned(*pair, allowed=0.05).regions


def test_an_edge_half_a_pixel_elsewhere_is_no_difference():
    fine = np.repeat(np.where(np.arange(4 * WIDTH) < 2 * WIDTH, 1.0, 0.1)[None, :], HEIGHT, axis=0)
    one, other = (np.roll(fine, step, axis=1).reshape(HEIGHT, WIDTH, 4).mean(axis=-1)[:, 5:-5] for step in (0, 2))
    pair = rendered(one, 1, 0.001), rendered(other, 2, 0.001)
    assert np.abs(one - other).max() > 0.4
    assert not scanned(*pair).regions


def test_a_bright_speck_of_one_half_is_no_difference():
    (_, (first, second)), theirs = rendered(scene(), 1, 0.01), rendered(scene(), 2, 0.01)
    first = first.copy()
    first[80, 100] += 50.0
    assert not scanned(((first + second) / 2, (first, second)), theirs).regions


def test_a_region_without_any_noise_is_found():
    plain = np.full((60, 60), 0.5)
    brighter = plain.copy()
    brighter[20:40, 20:40] = 0.6
    still = lambda light: (np.repeat(light[..., None], 3, axis=-1),) * 2  # noqa: E731
    found = scan(still(brighter)[0], still(plain)[0], (still(brighter), still(plain)), 0.01)
    assert len(found.regions) == 1


def test_the_layer_is_the_one_that_looks_like_the_difference():
    caustic = np.zeros((HEIGHT, WIDTH))
    caustic[40:60, 30:45] = 0.003
    pair = rendered(scene() + caustic, 1, 0.01), rendered(scene(), 2, 0.01)
    grey = lambda light: np.repeat(light[..., None], 3, axis=-1)  # noqa: E731
    region = scanned(*pair).regions[0]
    layers = {"diffusion": grey(scene()), "caustic": grey(caustic)}
    assert layer_of(region, pair[0][0] - pair[1][0], layers) == "caustic"
    assert layer_of(region, pair[0][0] - pair[1][0], {}) == ""


def test_pictures_that_cannot_be_scanned_are_refused():
    small = rendered(scene()[:10, :10], 1)
    with pytest.raises(MetricError, match="cannot be scanned"):
        scanned(small, small)
    with pytest.raises(MetricError, match="cannot be scanned"):
        scanned(rendered(scene(), 1), rendered(scene()[:80], 1))


def test_rounding_alone_is_no_difference_over_noise() -> None:
    """An even wall without noise, a quarter of a half-float step apart, is white and not red."""
    wall = np.full((40, 60, 3), 0.5)
    apart = wall * (1 + 2.0**-13)
    found = scan(wall, apart, ((wall, wall), (apart, apart)), 0.02)
    assert np.abs(found.over_noise).max() < 1
