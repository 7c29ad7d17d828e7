"""Torus and lathe against the definitions they have, and lathes against the shapes they contain."""

from __future__ import annotations

import math

import numpy as np
import pytest

from vitrail.geometry.placement import place
from vitrail.geometry.shapes.lathe import PlacedLathe
from vitrail.geometry.solid import Solid
from vitrail.scene.model import Object

ROD = [[0, -0.5], [0.4, -0.5], [0.4, 0.75], [0, 0.75]]
TUBE = [[0.4, 0.5], [0.7, 0.5], [0.7, -0.5], [0.4, -0.5]]
CUP = [[0, -0.6], [0.5, -0.6], [0.2, 0], [0.6, 0.5], [0.58, 0.5], [0, 0]]
POINTS = np.random.default_rng(7).uniform(-1, 1, (4000, 3))


def solid(kind: str, shape: dict, **where: list[float]) -> Solid:
    return place(Object.model_validate({"name": "it", "material": "m", kind: shape, **where}))


def lathe(profile: list[list[float]], **where: list[float]) -> PlacedLathe:
    found = solid("lathe", {"profile": profile}, **where)
    assert isinstance(found, PlacedLathe)
    return found


def test_a_torus_is_as_deep_as_the_distance_from_its_circle_says() -> None:
    """The nearest of 20 000 points of the circle is too far by at most half a step of 3.1e-4, squared: 1.2e-8 r."""
    ring = solid("torus", {"center": [0.1, -0.2, 0.3], "normal": [0, 0, 2], "radius": 0.5, "radius_tube": 0.2})
    angle = np.linspace(0, 2 * np.pi, 20_000, endpoint=False)
    circle = np.stack([0.1 + 0.5 * np.cos(angle), -0.2 + 0.5 * np.sin(angle), np.full_like(angle, 0.3)], axis=1)
    for point in POINTS[:50]:
        nearest = np.linalg.norm(circle - point, axis=1).min()
        assert ring.depth(point[None])[0] == pytest.approx(0.2 - nearest, abs=1e-6)


def test_a_lathe_of_a_rectangle_is_a_cylinder() -> None:
    """The same inside and the same depth there; outside a lathe measures to edges too, a cylinder does not."""
    turned = lathe(ROD, rotate_deg=[20, 0, 30], translate=[0.1, 0, 0])
    rod = {"from": [0, -0.5, 0], "to": [0, 0.75, 0], "radius": 0.4}
    plain = solid("cylinder", rod, rotate_deg=[20, 0, 30], translate=[0.1, 0, 0])
    inside = plain.depth(POINTS) > 0
    np.testing.assert_array_equal(turned.depth(POINTS) > 0, inside)
    np.testing.assert_allclose(turned.depth(POINTS)[inside], plain.depth(POINTS)[inside], atol=1e-14)
    assert turned.is_convex_or_flat and turned.thickness_m == pytest.approx(0.8, rel=1e-12)
    assert turned.bounds.low == pytest.approx(plain.bounds.low) and turned.bounds.high == pytest.approx(
        plain.bounds.high
    )


def test_a_lathe_shares_the_faces_of_the_cylinder_that_fills_its_bore() -> None:
    """The rod that fills the bore has both its ends in one plane with the tube's; the bore is seen from its inside."""
    tube = lathe(TUBE)
    inner = solid("cylinder", {"from": [0, -0.5, 0], "to": [0, 0.5, 0], "radius": 0.4}).faces
    outer = solid("cylinder", {"from": [0, -0.5, 0], "to": [0, 0.5, 0], "radius": 0.7}).faces
    assert sum(a.is_same(b) for a in tube.faces for b in inner) == 2
    assert sum(a.is_same(b) for a in tube.faces for b in outer) == 3
    cone = solid("cone", {"from": [0, 0, 0], "to": [0, 1, 0], "radius_from": 0.5, "radius_to": 0.25}).faces
    turned = lathe([[0, 0], [0.5, 0], [0.25, 1], [0, 1]]).faces
    assert sum(a.is_same(b) for a in turned for b in cone) == 3


@pytest.mark.parametrize(("profile", "convex"), [(ROD, True), (TUBE, False), (CUP, False)])
def test_only_a_body_without_hollows_is_convex(profile: list[list[float]], convex: bool) -> None:
    assert lathe(profile).is_convex_or_flat is convex
    assert lathe(profile[::-1]).is_convex_or_flat is convex


def test_a_dip_at_the_axis_is_a_hollow() -> None:
    """Its polygon turns left everywhere, and yet a line across the top leaves the body and meets it again."""
    assert not lathe([[0, 0], [0.5, 0], [0.5, 1], [0, 0.5]]).is_convex_or_flat
    assert lathe([[0, 0], [0.5, 0], [0.5, 1], [0, 1.5]]).is_convex_or_flat


@pytest.mark.parametrize("profile", [ROD, TUBE, CUP])
@pytest.mark.parametrize("by_m", [0.004, -0.004])
def test_what_has_grown_is_deeper_everywhere_by_that_much(profile: list[list[float]], by_m: float) -> None:
    """To rounding where a wall is nearest; where a corner is, by a little more or less."""
    body = lathe(profile, rotate_deg=[10, 20, 30])
    moved = body.grown(by_m).depth(POINTS) - body.depth(POINTS)
    assert (abs(moved - by_m) < 1e-12).mean() > 0.4
    assert (moved * by_m >= 0).all()


def test_a_cup_is_as_thick_as_its_thinnest_wall() -> None:
    """The rim is 0.02 wide; the slanted walls behind it are closer together."""
    assert lathe(TUBE).thickness_m == pytest.approx(0.3, rel=1e-12)
    assert 0.005 < lathe(CUP).thickness_m < 0.02


def test_a_torus_grows_by_its_tube_alone() -> None:
    ring = solid("torus", {"center": [0, 0, 0], "normal": [1, 1, 0], "radius": 0.5, "radius_tube": 0.2})
    grown = ring.grown(0.01)
    assert grown is not None
    np.testing.assert_allclose(grown.depth(POINTS) - ring.depth(POINTS), 0.01, atol=1e-15)
    assert ring.curvature_radius_m == 0.2 and ring.thickness_m == 0.4
    assert math.isclose(grown.distance((0.0, 0.0, 0.0)), 0.5 - 0.21, rel_tol=1e-12)


@pytest.mark.parametrize("gap_m", [0.0, 1e-3])
def test_a_torus_that_lies_on_a_plane_touches_it(gap_m: float) -> None:
    """Its lowest circle does, whatever its tilt."""
    tilt = math.radians(30)
    lowest = 0.5 * math.sin(tilt) + 0.2
    ring = solid(
        "torus",
        {
            "center": [0, lowest + gap_m, 0],
            "normal": [math.sin(tilt), math.cos(tilt), 0],
            "radius": 0.5,
            "radius_tube": 0.2,
        },
    )
    floor = solid("plane", {"point": [0, 0, 0], "normal": [0, 1, 0]})
    height = min(point[1] for point in ring.surface_points(floor))
    assert height == pytest.approx(gap_m, abs=1e-12)
