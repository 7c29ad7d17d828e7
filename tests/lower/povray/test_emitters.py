"""Small lights against closed forms: how far their sum is off, and whether the two halves say so."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import pytest

from vitrail.base.vector import unit
from vitrail.lower.povray.text.emitters import (
    Emitter,
    Grid,
    disc_points,
    rectangle_points,
    sphere_directions,
    sun_directions,
)
from vitrail.scene.model import Disc, Rectangle

pytestmark = pytest.mark.fast

SEEDS = range(100)


def disc(radius: float) -> Disc:
    return Disc(center=(0, 1, 0), normal=(0, -1, 0), radius=radius)


RECTANGLE = Rectangle(center=(0, 0, 0), u=(1, 0, 0), v=(0, 3, 0))


def irradiance(lamps: Sequence[Emitter], area: float) -> float:
    """E / L at the origin, of a card that faces +y, under lamps at height 1 that face it."""
    return area * math.fsum(each.share * each.position[1] ** 2 / math.hypot(*each.position) ** 4 for each in lamps)


def errors(value: Callable[[Grid], float], truth: float, count: int) -> tuple[float, float]:
    """Root mean squares, relative, of the error of the mean of both halves and of half their difference."""
    halves = np.array([[value(Grid(count, seed, half)) for half in (False, True)] for seed in SEEDS]) / truth - 1
    mean, apart = halves.mean(axis=1), (halves[:, 0] - halves[:, 1]) / 2
    return float(np.sqrt((mean**2).mean())), float(np.sqrt((apart**2).mean()))


@pytest.mark.parametrize("count", [1, 5, 24, 89])
def test_small_lights_share_the_whole_and_each_half_has_its_own(count: int) -> None:
    for make in (
        lambda grid: disc_points(disc(2), grid),
        lambda grid: rectangle_points(RECTANGLE, grid),
        sphere_directions,
    ):
        first, second = make(Grid(count, 7)), make(Grid(count, 7, is_second=True))
        assert math.fsum(each.share for each in first) == pytest.approx(1)
        assert len(first) == len(second) and first != second
    suns = sun_directions((0, -1, 0), 30, Grid(count, 7))
    facing = math.fsum(each.share * -each.direction[1] for each in suns)
    assert facing == pytest.approx(1)
    assert all(-each.direction[1] >= math.cos(math.radians(15)) - 1e-12 for each in suns)


def test_a_lattice_has_the_fibonacci_number_of_points_that_is_nearest() -> None:
    sizes = {count: len(list(Grid(count, 7).points())) for count in (1, 13, 21, 24, 30, 84)}
    assert sizes == {1: 1, 13: 13, 21: 21, 24: 21, 30: 34, 84: 89}
    assert len(sphere_directions(Grid(21, 7))) == 89


@pytest.mark.parametrize(("radius", "worst"), [(0.5, 5e-4), (2, 0.02)])
def test_a_disc_lamp_lights_as_its_closed_form_and_the_halves_know_the_error(radius: float, worst: float) -> None:
    """E = pi L R^2 / (R^2 + h^2). ``worst`` is twice what 21 lights were measured to err by.

    Squares of 100 errors scatter by 14 %, their ratio by 20 %: 0.5 to 2 is three of that.
    """
    area = math.pi * radius**2

    def value(grid: Grid) -> float:
        return irradiance(disc_points(disc(radius), grid), area)

    truth = area / (radius**2 + 1)
    few, known = errors(value, truth, 21)
    assert few < worst and 0.5 < (few / known) ** 2 < 2
    many, _ = errors(value, truth, 89)
    # 1 / n^2 is a factor of 18.
    assert many < few / 9


@pytest.mark.parametrize("normal", [(0, 1, 0), (1, 1, 0), (0.3, 0.5, 0.2)])
def test_a_constant_sky_lights_a_card_of_any_slant_with_pi_times_its_radiance(normal: tuple[float, ...]) -> None:
    facing = np.array(unit((normal[0], normal[1], normal[2])))

    def value(grid: Grid) -> float:
        found = sphere_directions(grid)
        return 4 * math.pi * math.fsum(each.share * max(-float(facing @ each.direction), 0) for each in found)

    error, known = errors(value, math.pi, 21)
    # Measured with 89 directions: 0.01 % for a card that faces a pole, 0.27 % at a slant.
    assert error < 0.004 and 0.5 < (error / known) ** 2 < 2


def test_the_penumbra_of_a_square_lamp_has_equal_steps() -> None:
    """Across an edge along a side of the lamp 55 lights stand at 55 places: none of its steps is two lights wide."""
    for seed in SEEDS:
        places = np.sort([each.position[0] for each in rectangle_points(RECTANGLE, Grid(55, seed))])
        lit = np.searchsorted(places, np.linspace(-1, 1, 201)) / 55
        assert np.abs(lit - np.linspace(0, 1, 201)).max() < 1.5 / 55
