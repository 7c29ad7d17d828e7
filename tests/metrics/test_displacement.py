"""Registration of patterns moved by a known part of a cell."""

from dataclasses import replace

import numpy as np
import pytest

from tests.metrics.synthetic import noisy, patch_of, value_of
from vitrail.metrics.displacement import displacement, edge_place
from vitrail.metrics.measurement import Context, MetricError

CELL = 2 / 64
CONTEXT = Context()


def checker(du=0.0, dv=0.0, gain=1.0, offset=0.0, size=0.25):
    """Each cell the exact mean of the pattern over it: a checker is the product of two square waves of height 1."""
    edges = np.linspace(-1, 1, 65)

    def means(shift):
        # The integral of the square wave is a triangle wave.
        phase = ((edges - shift) / size) % 2
        return np.diff(np.where(phase < 1, phase, 2 - phase)) * size / CELL

    odd = (1 - means(dv)[:, None] * means(du)[None, :]) / 2
    values = np.repeat((offset + gain * (0.1 + 0.8 * odd))[..., None], 3, axis=-1)
    return replace(patch_of(lambda u, v: 0 * u * v), values=values)


@pytest.mark.parametrize("cells", [0.0, 0.37, -0.37, 0.5, 2.63])
def test_a_checker_moved_by_a_part_of_a_cell(cells):
    found = displacement(checker(du=cells * CELL, dv=-cells * CELL / 2), checker(), CONTEXT)
    # What is left of a sharp edge beyond the band limit, after the smoothing, moves the answer by a hundredth.
    assert value_of(found, "displacement.u") / CELL == pytest.approx(cells, abs=0.01)
    assert value_of(found, "displacement.v") / CELL == pytest.approx(-cells / 2, abs=0.01)


@pytest.mark.parametrize("cells", [0.37, -1.21])
def test_a_smooth_pattern_is_registered_to_a_thousandth(cells):
    def waves(du):
        return patch_of(lambda u, v: 2 + np.sin(9 * (u - du)) + np.cos(7 * v + 3 * (u - du)))

    found = displacement(waves(cells * CELL), waves(0.0), CONTEXT)
    assert value_of(found, "displacement.u") / CELL == pytest.approx(cells, abs=1e-3)
    assert value_of(found, "displacement.v") / CELL == pytest.approx(0.0, abs=1e-3)


def test_exposure_and_haze_are_not_seen():
    for changed in (checker(gain=3.0), checker(gain=0.5, offset=0.4)):
        for m in displacement(changed, checker(), CONTEXT):
            assert m.value == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("gain", [0.05, 20.0])
def test_a_dimmed_picture_is_registered_as_well(gain):
    found = displacement(checker(du=0.37 * CELL, gain=gain), checker(), CONTEXT)
    assert value_of(found, "displacement.u") / CELL == pytest.approx(0.37, abs=0.01)


def test_stripes_have_one_direction_only():
    stripes = patch_of(lambda u, v: (np.floor(u / 0.25) % 2) + 0 * v)
    assert [m.metric for m in displacement(stripes, stripes, CONTEXT)] == ["displacement.u"]


def test_a_blank_patch_is_an_error():
    blank = patch_of(lambda u, v: 1 + 0 * u * v)
    with pytest.raises(MetricError, match="no pattern"):
        displacement(blank, blank, CONTEXT)


@pytest.mark.parametrize("place", [0.0, 0.0123, -0.1])
def test_the_place_of_one_edge(place):
    edge = patch_of(lambda u, v: np.clip((u - place) / 1e-9, 0, 1) + 0 * v, n_u=64)
    # The synthetic edge itself is quantised to an eighth of a cell.
    found = edge_place(edge, None, CONTEXT)
    assert value_of(found, "edge_place.u") == pytest.approx(place, abs=CELL / 16 * 1.01)


def test_an_edge_between_cells_of_known_share_is_exact():
    # Build the cells by hand: the one that the edge crosses holds 0.3 of the step, so the edge is at 0.7 of it.
    edge = patch_of(lambda u, v: 1.0 * (u > 0) + 0 * v)
    edge.values[:, 32] = 0.3
    assert value_of(edge_place(edge, None, CONTEXT), "edge_place.u") == pytest.approx(0.7 * CELL, abs=1e-4 * CELL)


def test_the_nearest_edge_of_a_pattern_is_taken():
    found = edge_place(checker(du=0.05), None, Context())
    # A checker's rows cancel in the mean over v: no edge, no number.
    assert found == []
    stripes = patch_of(lambda u, v: (np.floor((u - 0.0625) / 0.25) % 2) + 0 * v)
    assert value_of(edge_place(stripes, None, CONTEXT), "edge_place.u") == pytest.approx(0.0625, abs=1e-4)


def test_an_even_candidate_is_told_apart_from_a_displaced_one():
    pattern = patch_of(lambda u, v: 1 + np.sin(9 * u) * np.sin(9 * v))
    even = patch_of(lambda u, v: 0 * u * v + 1.0)
    with pytest.raises(MetricError, match="candidate shows no pattern"):
        displacement(even, pattern, Context())


def test_shading_is_no_pattern():
    """Gain and offset take up even shading, however steep: nothing says where it lies."""
    shaded = patch_of(lambda u, v: 1 + 0.4 * u + 0.3 * v + 0.05 * u * v)
    with pytest.raises(MetricError, match="no pattern"):
        displacement(shaded, shaded, CONTEXT)


def test_an_edge_shows_only_the_move_across_it():
    slanted = patch_of(lambda u, v: 1.0 + (v > 0.004 * u))
    found = displacement(slanted, slanted, CONTEXT)
    assert [m.metric for m in found] == ["displacement.v"]
    assert "along u no pattern" in found[0].caveats[0]


def test_noise_is_no_pattern():
    """Grain on an even patch has slopes of its own; a pattern under the same grain is still registered."""
    random = np.random.default_rng(7)
    halves = 0.02 * random.standard_normal((2, 64, 64, 3))

    def grained(picture):
        first, second = picture.values + halves[0], picture.values + halves[1]
        return replace(picture, values=(first + second) / 2, half_a=first, half_b=second)

    even = grained(patch_of(lambda u, v: 1 + 0 * u * v))
    with pytest.raises(MetricError, match="no pattern"):
        displacement(even, even, CONTEXT)
    assert {m.metric for m in displacement(grained(checker()), grained(checker()), CONTEXT)} == {
        "displacement.u",
        "displacement.v",
    }


def test_a_noisy_channel_does_not_blur_what_the_others_show():
    """Stray photons of a red mirror: red has twenty times the noise of green and blue, and the same pattern."""
    grain = 0.01 * np.array([20.0, 1.0, 1.0])

    def moves(noise):
        pairs = [
            (noisy(checker(du=0.37 * CELL), noise, seed), noisy(checker(), noise, 100 + seed)) for seed in range(8)
        ]
        return [value_of(displacement(*pair, CONTEXT), "displacement.u") / CELL for pair in pairs]

    quiet, loud = moves(0.01), moves(grain)
    # Two quiet channels of three scatter sqrt(3/2) as far; the mean of all would scatter 12 times as far.
    assert np.std(loud) < 3 * np.std(quiet)
    assert np.mean(loud) == pytest.approx(0.37, abs=0.01)


def test_a_channel_that_is_nearly_dark_does_not_count():
    """Behind obsidian blue has a millionth of the light, next to no noise, and comes through other edges."""
    grain = 0.01 * np.array([1.0, 1.0, 1e-6])
    bright = np.array([1.0, 1.0, 0.0])
    images = []
    for seed, red, blue in ((1, 0.37, 0.9), (2, 0.0, 0.0)):
        picture = checker(du=red * CELL)
        values = picture.values * bright + 1e-6 * checker(du=blue * CELL).values * (1 - bright)
        images.append(noisy(replace(picture, values=values), grain, seed))
    assert value_of(displacement(*images, CONTEXT), "displacement.u") / CELL == pytest.approx(0.37, abs=0.02)
