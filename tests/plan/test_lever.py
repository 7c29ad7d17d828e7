"""Pixels per radian, against geometry done by hand."""

from __future__ import annotations

import math

import pytest

from tests.plan.small_scenes import ball_over_floor
from vitrail.geometry.world import World
from vitrail.plan.evidence.angles import mean_tangent
from vitrail.plan.lever import lever_on, lever_through

PIXEL = 2 * math.tan(math.radians(20)) / 100


def test_a_turn_at_the_ball_lands_its_height_away() -> None:
    """The ball is 2 above the floor, the camera 8: a pixel covers 8 m times its angle."""
    scene = ball_over_floor()
    lever = lever_on(World.of_scene(scene), scene.objects[1], scene.objects[0])
    assert lever.typical_px == pytest.approx(2 / (8 * PIXEL))
    assert lever.most_px >= lever.typical_px


def test_no_seen_point_of_the_floor_has_a_longer_lever_than_the_most() -> None:
    """Light from the ball's centre to a floor point at distance d, seen at distance D, moves d / D radians."""
    scene = ball_over_floor()
    lever = lever_on(World.of_scene(scene), scene.objects[1], scene.objects[0])
    for x in (0.0, 1.0, 3.0, 10.0, 100.0):
        assert math.hypot(x, 2) / math.hypot(x, 8) / PIXEL <= lever.most_px


def test_an_orthographic_lever_is_a_length() -> None:
    flat = "{kind: orthographic, position: [0, 8, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 4}"
    scene = ball_over_floor(camera=flat)
    lever = lever_on(World.of_scene(scene), scene.objects[1], scene.objects[0])
    assert lever.typical_px == pytest.approx(2 / 0.04)
    # The corner of the picture is hypot(2, 2) aside; the ball's bounds add sqrt 3.
    assert lever.most_px == pytest.approx((math.hypot(2, 2, 2) + math.sqrt(3)) / 0.04)


def test_what_is_seen_through_glass_turns_as_the_ray_does() -> None:
    scene = ball_over_floor()
    assert lever_through(World.of_scene(scene).view).most_px == pytest.approx(1 / PIXEL)


@pytest.mark.parametrize(("roughness", "tangent"), [(0.1, 0.020315), (0.3, 0.065549), (0.5, 0.118382), (1.0, 0.303395)])
def test_the_mean_deflection_is_that_of_the_closed_form(roughness: float, tangent: float) -> None:
    """[O 1.3], table of equation 8, to the six digits printed."""
    assert mean_tangent(roughness) == pytest.approx(tangent, abs=5e-7)


def test_the_series_of_the_mean_deflection_meets_the_closed_form() -> None:
    """At 2e-4 the closed form has lost 4 digits of 16, the series is good to (1e-4)^2."""
    assert mean_tangent(1.999e-4) == pytest.approx(mean_tangent(2.001e-4), rel=2e-3)
    assert mean_tangent(1.9999e-4) / mean_tangent(2.0001e-4) == pytest.approx(1.9999 / 2.0001, rel=1e-7)
