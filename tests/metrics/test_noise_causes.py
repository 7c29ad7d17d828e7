"""Noise of a known cause is told from the others by where it is."""

from __future__ import annotations

import numpy as np
import pytest

from vitrail.metrics.noise_causes import noise_causes

CELLS = (80, 90)
RNG = np.random.default_rng(4)


def drawn(variance: np.ndarray) -> np.ndarray:
    """One realisation of noise of this variance, alike in the channels as that of photons is."""
    return (np.sqrt(variance) * RNG.standard_normal(CELLS))[..., None] * np.ones(3)


def grey(light: np.ndarray) -> np.ndarray:
    return light[..., None] * np.ones(3)


@pytest.fixture
def photons() -> np.ndarray:
    """A bright spot of photons in the middle."""
    y, x = np.mgrid[-1 : 1 : CELLS[0] * 1j, -1 : 1 : CELLS[1] * 1j]
    return 5 * np.exp(-(x**2 + y**2) / 0.1)


@pytest.fixture
def tiles() -> np.ndarray:
    """A checker with edges in both directions."""
    rows, columns = np.indices(CELLS)
    return 0.2 + 0.6 * ((rows // 16 + columns // 16) % 2)


def test_each_cause_is_found_alone(photons: np.ndarray, tiles: np.ndarray) -> None:
    slopes = sum(np.gradient(photons + tiles, axis=axis) ** 2 for axis in (0, 1))
    for name, field in {"photons": photons, "edges": slopes, "rays": tiles**2}.items():
        found = noise_causes(drawn(1e-3 * field), grey(photons + tiles), {"caustic": grey(photons)})
        whole = found.photons + found.edges + found.rays
        # The variance of a mean of n squares is 2/n of its square: 5 % of what 1000 lit cells say.
        assert getattr(found, name) == pytest.approx(1e-3 * field.mean(), rel=0.15)
        assert getattr(found, name) > 0.9 * whole


def test_the_rim_of_a_sharp_spot_is_an_edge_of_its_own() -> None:
    """Light that photons brought evenly into a disc: samples at its rim are noisy besides."""
    rows, columns = np.indices(CELLS)
    spot = np.where((rows - 40) ** 2 + (columns - 45) ** 2 < 20**2, 5.0, 0.0)
    slopes = sum(np.gradient(spot, axis=axis) ** 2 for axis in (0, 1))
    found = noise_causes(drawn(0.1 * slopes + 1e-2 * spot), grey(spot), {"caustic": grey(spot)}, draws_rays=False)
    assert found.edges == pytest.approx(0.1 * slopes.mean(), rel=0.3)
    assert found.photons == pytest.approx(1e-2 * spot.mean(), rel=0.3)


def test_two_causes_together_keep_their_shares(photons: np.ndarray, tiles: np.ndarray) -> None:
    variance = 1e-3 * photons / photons.mean() + 3e-3 * tiles**2 / (tiles**2).mean()
    found = noise_causes(drawn(variance), grey(photons + tiles), {"caustic": grey(photons)})
    assert found.photons / (found.photons + found.edges + found.rays) == pytest.approx(0.25, abs=0.05)


def test_smooth_light_gives_samples_no_noise(photons: np.ndarray) -> None:
    """An even patch in the far light of a caustic: both fields are flat, and only one of them can be the cause."""
    flat = 0.2 + 1e-3 * np.indices(CELLS)[0]
    found = noise_causes(drawn(1e-3 * flat), grey(2 * flat), {"caustic": grey(flat)}, draws_rays=False)
    assert found.photons == pytest.approx(1e-3 * flat.mean(), rel=0.1)
    assert found.edges < 0.01 * found.photons and found.rays == 0


def test_where_photons_brought_no_light_no_noise_is_theirs(tiles: np.ndarray) -> None:
    found = noise_causes(drawn(1e-3 * tiles**2), grey(tiles), {"caustic": np.zeros((*CELLS, 3))})
    assert found.photons == 0 and found.rays > 0
    silent = noise_causes(np.zeros((*CELLS, 3)), grey(tiles), {})
    assert (silent.photons, silent.edges, silent.rays) == (0, 0, 0)
