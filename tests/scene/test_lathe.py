"""The shipped meshes are what tools/lathe.py makes, closed, and face outwards."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, "tools")
from lathe import (  # noqa: E402
    GOBLET_INSIDE,
    GOBLET_OUTSIDE,
    GOBLET_RIM,
    WINE_LEVEL_M,
    lathe,
    profile,
    spline,
    volume,
    write_ply,
)

pytestmark = pytest.mark.slow

SHIPPED = ("vase", "goblet", "wine")


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_mesh_is_made_by_the_tool(name: str) -> None:
    """Coordinates are written with seven digits; the last may differ between libraries."""
    made = write_ply(*lathe(profile(name)), name).splitlines()
    shipped = Path(f"scenes/paper/{name}.ply").read_text(encoding="utf-8").splitlines()
    assert len(made) == len(shipped)
    for ours, theirs in zip(made, shipped, strict=True):
        if ours != theirs:
            np.testing.assert_allclose([float(x) for x in ours.split()], [float(x) for x in theirs.split()], atol=2e-8)


@pytest.mark.parametrize("name", SHIPPED)
def test_a_mesh_is_closed_and_faces_outwards(name: str) -> None:
    vertices, faces = lathe(profile(name))
    edges = Counter((face[k], face[(k + 1) % 3]) for face in faces.tolist() for k in range(3))
    assert set(edges.values()) == {1}
    assert all((b, a) in edges for a, b in edges)
    assert volume(vertices, faces) > 0


@pytest.mark.parametrize("name", SHIPPED)
def test_a_profile_does_not_cross_itself(name: str) -> None:
    """Where it does, the inside of a wall lies outside: light is then caught in a face, and the rim is black."""
    points = profile(name)
    starts, ways = points[:-1], np.diff(points, axis=0)

    def side(k: int, at: np.ndarray) -> np.ndarray:
        """On which side of segment k points lie, seen along it."""
        away = at - starts[k]
        return np.sign(ways[k, 0] * away[:, 1] - ways[k, 1] * away[:, 0])

    sides = np.array([side(k, points) for k in range(len(starts))])
    parts = sides[:, :-1] * sides[:, 1:] < 0
    crossing = [(i, j) for i, j in np.argwhere(parts & parts.T) if abs(i - j) > 1]
    assert crossing == []


def test_the_volume_is_that_of_the_turned_profile() -> None:
    """Pappus: 2 pi times the area's moment about the axis; 72 corners of a circle have sin(x) / x of its area."""
    r, y = profile().T
    moment = np.sum((r[:-1] * r[:-1] + r[:-1] * r[1:] + r[1:] * r[1:]) * np.diff(y)) / 6
    corner = 2 * np.pi / 72
    assert volume(*lathe(profile())) == pytest.approx(2 * np.pi * moment * np.sin(corner) / corner, rel=1e-12)


def test_the_tool_writes_to_standard_output() -> None:
    done = subprocess.run([sys.executable, "tools/lathe.py"], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout.startswith("ply\nformat ascii 1.0\n")


def test_the_wine_reaches_into_the_wall_and_not_through_it() -> None:
    """At every height of the wine its radius lies between the inside and the outside of the goblet."""
    goblet, wine = spline(np.concatenate([GOBLET_OUTSIDE, GOBLET_RIM, GOBLET_INSIDE]), 4000), profile("wine")
    top = np.argmax(goblet[:, 1])
    outside, inside = goblet[:top], goblet[top:][::-1]
    wall = wine[(wine[:, 1] < WINE_LEVEL_M) & (wine[:, 1] > 0.09)]
    heights = wall[:, 1]
    assert np.all(wall[:, 0] > np.interp(heights, inside[:, 1], inside[:, 0]) + 2e-4)
    outer = outside[outside[:, 1] > 0.07]
    assert np.all(wall[:, 0] < np.interp(heights, outer[:, 1], outer[:, 0]) - 2e-4)
