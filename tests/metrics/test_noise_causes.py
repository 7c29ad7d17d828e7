"""Noise of a known cause is told from the others by where it is."""

from __future__ import annotations

import numpy as np
import pytest

from vitrail.metrics.noise_causes import noise_causes

CELLS = (80, 90)
NOTHING = np.zeros((*CELLS, 3))
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
        found = noise_causes(drawn(1e-3 * field), grey(photons + tiles), grey(photons), grey(tiles))
        whole = found.photons + found.edges + found.rays
        # The variance of a mean of n squares is 2/n of its square: 5 % of what 1000 lit cells say.
        assert getattr(found, name) == pytest.approx(1e-3 * field.mean(), rel=0.15)
        assert getattr(found, name) > 0.9 * whole


def test_the_rim_of_a_sharp_spot_is_an_edge_of_its_own() -> None:
    """Light that photons brought evenly into a disc: samples at its rim are noisy besides."""
    rows, columns = np.indices(CELLS)
    spot = np.where((rows - 40) ** 2 + (columns - 45) ** 2 < 20**2, 5.0, 0.0)
    slopes = sum(np.gradient(spot, axis=axis) ** 2 for axis in (0, 1))
    found = noise_causes(drawn(0.1 * slopes + 1e-2 * spot), grey(spot), grey(spot), NOTHING)
    assert found.edges == pytest.approx(0.1 * slopes.mean(), rel=0.3)
    assert found.photons == pytest.approx(1e-2 * spot.mean(), rel=0.3)


def test_two_causes_together_keep_their_shares(photons: np.ndarray, tiles: np.ndarray) -> None:
    variance = 1e-3 * photons / photons.mean() + 3e-3 * tiles**2 / (tiles**2).mean()
    found = noise_causes(drawn(variance), grey(photons + tiles), grey(photons), grey(tiles))
    assert found.photons / (found.photons + found.edges + found.rays) == pytest.approx(0.25, abs=0.05)


def test_smooth_light_gives_samples_no_noise(photons: np.ndarray) -> None:
    """An even patch in the far light of a caustic: both fields are flat, and only one of them can be the cause."""
    flat = 0.2 + 1e-3 * np.indices(CELLS)[0]
    found = noise_causes(drawn(1e-3 * flat), grey(2 * flat), grey(flat), NOTHING)
    assert found.photons == pytest.approx(1e-3 * flat.mean(), rel=0.1)
    assert found.edges < 0.01 * found.photons and found.rays == 0


def test_where_photons_brought_no_light_no_noise_is_theirs(tiles: np.ndarray) -> None:
    found = noise_causes(drawn(1e-3 * tiles**2), grey(tiles), NOTHING, grey(tiles))
    assert found.photons == 0 and found.rays > 0
    silent = noise_causes(NOTHING, grey(tiles), NOTHING, grey(tiles))
    assert (silent.photons, silent.edges, silent.rays) == (0, 0, 0)


def test_a_peak_finer_than_cells_is_a_matter_of_samples() -> None:
    """The focus of a ball: one cell holds a third of the light, and the samples meet it or not.

    Its gradient is nothing in that very cell, so once all of it counted as noise of photons.
    """
    rows, columns = np.indices(CELLS)
    photons = 1 / (1 + ((rows - 40) ** 2 + (columns - 45) ** 2) / 30)
    photons[40, 45] += 0.5 * photons.sum()
    peak = np.zeros(CELLS)
    peak[39:42, 44:47] = 1.0
    shot = 1e-2 * np.minimum(photons, 1.0)
    halves = drawn(shot + 20.0 * peak)
    found = noise_causes(halves, grey(photons) + halves, grey(photons), NOTHING)
    # Nine cells say no more of a variance than half of it.
    assert found.edges > 10 * found.photons
    assert found.photons == pytest.approx(shot.mean(), rel=0.5)


def test_noise_of_photons_is_no_edge(photons: np.ndarray) -> None:
    """What photons add to the light varies from cell to cell as edges do, but not alike in both halves."""
    even = 1 + 0.1 * photons
    noise, other = drawn(0.05 * even), drawn(0.05 * even)
    found = noise_causes(noise, grey(even) + other, grey(even), NOTHING)
    assert found.edges < 0.1 * found.photons


def test_discs_of_many_cells_count_as_often() -> None:
    """A sum over a patch has fewer discs than cells: noise alike over 9 cells weighs 9 times as much in it."""
    rows = np.indices(CELLS)[0]
    even = 1 + 1e-3 * rows
    noise = drawn(1e-3 * even)
    alone, shared = (noise_causes(noise, grey(even), grey(even), NOTHING, disc_cells=cells) for cells in (0.3, 9.0))
    assert shared.photons == pytest.approx(9 * alone.photons)
