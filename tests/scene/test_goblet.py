"""The wine of ``scenes/paper/goblet.yaml`` reaches into the wall of its glass everywhere, and nowhere through it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from vitrail.scene.load import load
from vitrail.scene.model import Lathe

SCENE = load(Path("scenes/paper/goblet.yaml")).scene


def profile(name: str) -> np.ndarray:
    """(n, 2) radius and height of a lathe, metres."""
    shape = next(item.shape for item in SCENE.objects if item.name == name)
    assert isinstance(shape, Lathe)
    return np.array(shape.profile)


def test_the_wine_reaches_into_the_wall_and_not_through_it() -> None:
    """0.2 mm at least on either side, at every height between the bottom of the bowl and the level."""
    goblet, wine = profile("goblet"), profile("wine")
    top, level = int(np.argmax(goblet[:, 1])), float(wine[:, 1].max())
    outside, inside = goblet[:top], goblet[top:][::-1]
    wall = wine[(wine[:, 1] > 0.09) & (wine[:, 1] < level)]
    assert len(wall) > 30
    heights = wall[:, 1]
    assert np.all(wall[:, 0] > np.interp(heights, inside[:, 1], inside[:, 0]) + 2e-4)
    outer = outside[outside[:, 1] > 0.07]
    assert np.all(wall[:, 0] < np.interp(heights, outer[:, 1], outer[:, 0]) - 2e-4)


def test_the_wine_is_level_and_above_nothing_but_glass() -> None:
    """Its top is one flat ring to the axis; its bottom lies in the bowl's."""
    goblet, wine = profile("goblet"), profile("wine")
    assert wine[-1].tolist() == [0.0, wine[-2, 1]] and wine[-1, 1] == wine[:, 1].max()
    bowl = goblet[-1, 1]
    assert wine[0, 0] == 0 and bowl - 1e-3 < wine[0, 1] < bowl
