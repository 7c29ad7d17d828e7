"""What is small beside the whole scene, or far away: seen as it is, or refused at its line; never black in silence."""

from __future__ import annotations

import math

import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, SUN, lowered, rendered, scene
from vitrail.lower.povray import NotTranslatable

pytestmark = pytest.mark.povray

CARD = "- {name: card, rectangle: {center: [0, 0, 0], u: [0.7, 0, 0], v: [0, 0, -0.7]}, material: white}"
WHITE = "white: {diffuse: 1}"


@pytest.mark.parametrize("away_m", [1e3, 3e5, 1e6])
def test_a_distant_lamp_lights_a_card(away_m: float) -> None:
    """I / (pi r^2) of a lamp so far that the card is a speck in the scene; POV-Ray drops small polygons."""
    lamp = f"- {{name: lamp, point: {{position: [0, {away_m}, 0], intensity: {math.pi * away_m**2}}}}}"
    assert rendered(scene(WHITE, CARD, lamp)).image.radiance == pytest.approx(1, rel=HALF_FLOAT)


def test_a_card_too_small_beside_a_lamp_too_far_is_refused_with_its_line() -> None:
    lamp = "- {name: lamp, point: {position: [0, 2.0e+7, 0], intensity: 1}}"
    with pytest.raises(NotTranslatable, match=r"scene.yaml:\d+:\d+: a rectangle of 1.4 m .* with its lamps smaller"):
        lowered(scene(WHITE, CARD, lamp))


@pytest.mark.parametrize("radius_m", [1e3, 2e5, 1e6])
def test_a_huge_ball_is_a_ground(radius_m: float) -> None:
    """The radiance of a facing Lambert surface under the sun; hits nearer than 1e-4 units are not seen."""
    ground = f"- {{name: ground, sphere: {{center: [0, -{radius_m}, 0], radius: {radius_m}}}, material: white}}"
    assert rendered(scene(WHITE, ground, SUN)).image.radiance == pytest.approx(1, rel=HALF_FLOAT)


def test_a_camera_too_near_a_ball_too_large_is_refused_with_its_line() -> None:
    ground = "- {name: ground, sphere: {center: [0, -3.0e+7, 0], radius: 3.0e+7}, material: white}"
    with pytest.raises(NotTranslatable, match=r"scene.yaml:2:\d+: the camera's distance from a surface .* use a plane"):
        lowered(scene(WHITE, ground, SUN))


def test_a_plane_is_seen_by_a_wide_camera_or_the_camera_is_refused() -> None:
    """Of a glowing plane 2 m ahead 179 degrees show all; at 179.9999 most of it is 1e7 units away."""
    wall = "- {name: wall, plane: {point: [0, 0, -2], normal: [0, 0, 1]}, material: glow}"

    def before(fov_deg: float) -> str:
        return f"camera: {{position: [0, 0, 0], look_at: [0, 0, -1], fov_deg: {fov_deg}}}"

    seen = rendered(scene("glow: {emission: 1}", wall, "", before(179)))
    assert seen.image.radiance == pytest.approx(1, rel=HALF_FLOAT)
    with pytest.raises(NotTranslatable, match=r"scene.yaml:2:\d+: in 9\d.\d% of the picture a plane is farther"):
        lowered(scene("glow: {emission: 1}", wall, "", before(179.9999)))
