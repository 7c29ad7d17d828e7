"""Containment and overlap of solids against geometry that can be worked out by hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from vitrail.geometry.overlap import overlap
from vitrail.geometry.placement import place
from vitrail.geometry.solid import Solid
from vitrail.scene.model import Object

UNIT_BOX = {"min": (-1, -1, -1), "max": (1, 1, 1)}


def solid(rotate_deg: Any = (0, 0, 0), translate: Any = (0, 0, 0), **shape: Any) -> Solid:
    return place(Object(name="a", material="m", rotate_deg=rotate_deg, translate=translate, **shape))


def ball(x: float, radius: float = 1, y: float = 0, z: float = 0) -> Solid:
    return solid(sphere={"center": (x, y, z), "radius": radius})


# Shape, a point inside with its depth, a point outside.
INSIDE = [
    (ball(1), (1.5, 0, 0), 0.5, (2.1, 0, 0)),
    (solid(plane={"point": (0, 1, 0), "normal": (0, 2, 0)}), (5, 0.25, 7), 0.75, (0, 1.1, 0)),
    (solid(box=UNIT_BOX, rotate_deg=(0, 45, 0)), (1.2, 0, 0), 1 - 1.2 / math.sqrt(2), (1.1, 0, 1.1)),
    (solid(box=UNIT_BOX, translate=(10, 0, 0)), (10.5, 0, 0), 0.5, (0, 0, 0)),
    (solid(cylinder={"from": (0, 0, 0), "to": (0, 4, 0), "radius": 1}), (0.5, 2, 0), 0.5, (0, 4.1, 0)),
    (
        # The mantle falls 1 in 1, so its distance is the horizontal gap over sqrt(2).
        solid(cone={"from": (0, 0, 0), "to": (0, 2, 0), "radius_from": 2, "radius_to": 0}),
        (0.5, 1, 0),
        0.5 / math.sqrt(2),
        (1.1, 1, 0),
    ),
    (solid(prism={"apex_deg": 60, "side": 2, "height": 2}), (0, 0, 0), math.sqrt(3) / 3, (0, 1.2, 0)),
    (
        # An L: the notch is outside.
        solid(prism={"profile": [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], "height": 9}),
        (0.5, 1.5, 0),
        0.5,
        (1.5, 1.5, 0),
    ),
    (
        # The front face is at -z: convex there, hollow at +z.
        solid(lens={"radius_front": 2, "radius_back": -3, "thickness": 0.2, "diameter": 1}),
        (0, 0, -0.05),
        0.05,
        (0, 0, 0.101),
    ),
]


@pytest.mark.parametrize(("item", "inside", "depth", "outside"), INSIDE)
def test_depth_inside_each_shape(item: Solid, inside: Any, depth: float, outside: Any) -> None:
    assert item.depth(np.array([inside]))[0] == pytest.approx(depth, rel=1e-12)
    assert item.contains(inside) and not item.contains(outside)


def test_a_line_that_enters_and_leaves_a_profile_is_outside_before_it() -> None:
    bar = solid(prism={"profile": [(0, 0), (2, 0), (2, 1), (0, 1)], "height": 9})
    assert bar.depth(np.array([(-1, 0.5, 0)]))[0] == -1


def test_flat_shapes_have_no_inside() -> None:
    assert not solid(disc={"center": (0, 0, 0), "normal": (0, 1, 0), "radius": 1}).contains((0, 0, 0))


def test_the_hollow_face_of_a_lens_holds_glass_beyond_its_vertex() -> None:
    lens = solid(lens={"radius_front": 2, "radius_back": -3, "thickness": 0.2, "diameter": 1})
    assert lens.contains((0.49, 0, 0.12)) and not lens.contains((0, 0, 0.12))


# Two solids and how far they reach into each other; None where only the search can tell.
EXACT = [
    (ball(0), ball(1.5), 0.5),
    (ball(0), ball(2.5), -0.5),
    (ball(0, 1), ball(0, 0.25), 1.25),
    (ball(1.5), solid(box=UNIT_BOX), 0.5),
    (ball(0, 0.1), solid(box=UNIT_BOX), 1.1),
    # A corner on the x axis after turning by 45 degrees: the box reaches sqrt(2), the sphere starts at 2.4.
    (ball(3.4), solid(box=UNIT_BOX, rotate_deg=(0, 45, 0)), math.sqrt(2) - 2.4),
    (solid(box=UNIT_BOX), solid(box=UNIT_BOX, translate=(1.75, 0, 0)), 0.25),
    (solid(box=UNIT_BOX), solid(box=UNIT_BOX, translate=(2.25, 0, 0)), -0.25),
    (solid(box=UNIT_BOX), solid(box=UNIT_BOX, rotate_deg=(0, 45, 0), translate=(2.4, 0, 0)), math.sqrt(2) - 1.4),
    (solid(plane={"point": (0, 0, 0), "normal": (0, 1, 0)}), ball(0, 1, 0.75), 0.25),
    (solid(plane={"point": (0, 0, 0), "normal": (0, 1, 0)}), solid(box=UNIT_BOX, translate=(0, 1.5, 0)), -0.5),
]


@pytest.mark.parametrize(("one", "two", "depth"), EXACT)
def test_pairs_with_a_closed_form(one: Solid, two: Solid, depth: float) -> None:
    found = overlap(one, two)
    assert found.exact
    # Each depth is reduced by the touching tolerance of 1e-9 of the solids' size, here below 1e-8.
    assert found.depth_m == pytest.approx(depth, abs=1e-8)
    assert overlap(two, one).depth_m == pytest.approx(found.depth_m, abs=1e-15)
    assert bool(found) == (depth > 0)


def test_boxes_that_only_edge_against_edge_axes_separate() -> None:
    """Two crossed rods pass each other with a gap that no face normal shows."""
    rod = {"min": (-0.5, -0.5, -10), "max": (0.5, 0.5, 10)}
    one = solid(box=rod, rotate_deg=(0, 0, 45))
    near = solid(box=rod, rotate_deg=(0, 90, 0))
    # One rod shows its edge (at 1/sqrt 2) upwards, the other is turned about x to show its edge downwards.
    other = {"min": (-10, -0.5, -0.5), "max": (10, 0.5, 0.5)}
    apart = solid(box=other, rotate_deg=(45, 0, 0), translate=(0, 1.42, 0))
    close = solid(box=other, rotate_deg=(45, 0, 0), translate=(0, 1.41, 0))
    assert not overlap(one, apart) and overlap(one, close) and overlap(one, near)


def test_touching_is_not_overlapping() -> None:
    assert not overlap(ball(0), ball(2))
    # 0.1 + 0.1 exceeds 0.3 - 0.1 by rounding alone.
    assert not overlap(ball(0.1, 0.1), ball(0.3, 0.1))
    assert not overlap(solid(box=UNIT_BOX), solid(box=UNIT_BOX, translate=(2, 0, 0)))
    assert not overlap(solid(box=UNIT_BOX), solid(cylinder={"from": (0, 1, 0), "to": (0, 3, 0), "radius": 0.5}))


@pytest.mark.parametrize(
    ("one", "two", "shares"),
    [
        (solid(cylinder={"from": (0, -5, 0), "to": (0, 5, 0), "radius": 0.1}), ball(1.05), True),
        (solid(cylinder={"from": (0, -5, 0), "to": (0, 5, 0), "radius": 0.1}), ball(1.2), False),
        (solid(prism={"apex_deg": 60, "side": 2, "height": 2}), ball(0, 0.3, 1.4), True),
        (solid(prism={"apex_deg": 60, "side": 2, "height": 2}), ball(0, 0.3, 1.6), False),
        (
            solid(lens={"radius_front": 2, "radius_back": 2, "thickness": 0.2, "diameter": 1}),
            solid(box={"min": (-1, -1, 0.09), "max": (1, 1, 1)}),
            True,
        ),
    ],
)
def test_the_search_finds_shared_volume(one: Solid, two: Solid, shares: bool) -> None:
    found = overlap(one, two)
    assert bool(found) is shares and not found.exact


def test_distances_to_surfaces() -> None:
    rectangle = solid(rectangle={"center": (0, 0, 0), "u": (1, 0, 0), "v": (0, 0, 2)})
    assert rectangle.distance((0.5, 0, 1.5)) == 0
    assert rectangle.distance((4, 0, 2)) == pytest.approx(3, rel=1e-15)
    assert rectangle.distance((0, 2, 0)) == 2
    disc = solid(disc={"center": (0, 0, 0), "normal": (0, 1, 0), "radius": 1})
    assert disc.distance((4, 4, 0)) == pytest.approx(5, rel=1e-15)
    assert ball(0).distance((0, 3, 0)) == 2
    assert solid(mesh={"file": "a.ply"}).distance((0, 0, 0)) == math.inf
