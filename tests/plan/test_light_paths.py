"""Caustic paths exist where light can take them, and nowhere that geometry rules out."""

from __future__ import annotations

import pytest

from tests.plan.small_scenes import BALL, FLOOR, SUN, ball_over_floor, make
from vitrail.geometry.world import World
from vitrail.plan.light_paths import caustic_paths
from vitrail.scene.model import Scene

LAMPS = {
    "point": "{name: lamp, point: {position: [0, 6, 0], intensity: 1}}",
    "spot_at": "{name: lamp, spot: {position: [0, 6, 0], direction: [0, -1, 0], intensity: 1, cone_deg: 10}}",
    "spot_beside": "{name: lamp, spot: {position: [5, 6, 0], direction: [0, -1, 0], intensity: 1, cone_deg: 10}}",
    "area": "{name: lamp, area: {disc: {center: [0, 6, 0], normal: [0, -1, 0], radius: 1}, radiance: 1}}",
    "area_away": "{name: lamp, area: {disc: {center: [0, 6, 0], normal: [0, 1, 0], radius: 1}, radiance: 1}}",
    "beam": "{name: lamp, area: {disc: {center: [1, 6, 0], normal: [0, -1, 0], radius: 1}, collimated: true,"
    " irradiance: 1}}",
    "beam_beside": "{name: lamp, area: {disc: {center: [9, 6, 0], normal: [0, -1, 0], radius: 1}, collimated: true,"
    " irradiance: 1}}",
    "sky": "{name: lamp, environment: {radiance: 1}}",
    "dark": "{name: lamp, point: {position: [0, 6, 0], intensity: 0}}",
}


def names(scene: Scene) -> set[tuple[str, str, str]]:
    return {(path.light, path.specular, path.receiver) for path in caustic_paths(World.of_scene(scene))}


@pytest.mark.parametrize(
    ("lamp", "reaches"),
    [
        ("point", True),
        ("spot_at", True),
        ("spot_beside", False),
        ("area", True),
        ("area_away", False),
        ("beam", True),
        ("beam_beside", False),
        ("sky", True),
        ("dark", False),
    ],
)
def test_a_light_has_to_reach_the_glass(lamp: str, reaches: bool) -> None:
    found = names(ball_over_floor("clear", lights=(LAMPS[lamp],)))
    assert found == ({("lamp", "ball", "floor")} if reaches else set())


ROOF = "{name: roof, plane: {point: [0, %s, 0], normal: [0, 1, 0]}, material: %s}"
UNDER_THE_ROOF = "{position: [0, 1.5, 6], look_at: [0, 0, 0], fov_deg: 40}"
HALF_UP = "{name: sun, directional: {direction: [1, -0.01, 0], irradiance: 3, angular_diameter_deg: %s}}"


@pytest.mark.parametrize(
    ("roof", "lamp", "reaches"),
    [
        (ROOF % (4, "black"), SUN, False),
        (ROOF % (3, "white"), SUN, False),
        ((ROOF % (4, "black")).replace("[0, 1, 0]", "[0, -1, 0]"), SUN, False),
        (ROOF % (4, "black"), LAMPS["point"], False),
        (ROOF % (4, "black"), LAMPS["spot_at"], False),
        # The plane cuts through the ball, or stands above the lamp, or below the ball.
        (ROOF % (2.5, "black"), SUN, True),
        (ROOF % (7, "black"), LAMPS["point"], True),
        (ROOF % (0.5, "black"), SUN, True),
        # Some of a wide sun shines from below the horizon; some of a sky does always.
        (ROOF % (4, "black"), HALF_UP % 0.5, False),
        (ROOF % (4, "black"), HALF_UP % 2, True),
        (ROOF % (4, "black"), LAMPS["sky"], True),
        # A mirror, and glass below the plane, are lit themselves.
        (ROOF % (4, "mirror"), SUN, True),
    ],
)
def test_an_infinite_plane_before_the_glass_leaves_no_caustic(roof: str, lamp: str, reaches: bool) -> None:
    """Both engines block all light that has to cross it."""
    found = names(make(FLOOR, BALL % "clear", roof, lights=(lamp,), camera=UNDER_THE_ROOF))
    assert bool(found) == reaches


def test_a_convex_mirror_does_not_light_itself() -> None:
    glossy = "{name: ball, sphere: {center: [0, 2, 0], radius: 1}, material: glossy}"
    scene = make(FLOOR, glossy.replace("glossy", "white"))
    assert names(scene) == set()
    material = scene.materials["white"].model_copy(update={"reflection": (0.1, 0.1, 0.1)})
    shiny = scene.model_copy(update={"materials": {**scene.materials, "white": material}})
    # Floor and ball are glossy now: each may light the other, none itself.
    assert names(shiny) == {("sun", "floor", "ball"), ("sun", "ball", "floor")}


def test_scattering_glass_is_lit_from_inside() -> None:
    scene = ball_over_floor("clear")
    milky = scene.materials["clear"].model_copy(update={"transmission": (0.9,) * 3, "diffuse": (0.1,) * 3})
    found = names(scene.model_copy(update={"materials": {**scene.materials, "clear": milky}}))
    assert found == {("sun", "ball", "floor"), ("sun", "ball", "ball")}


def test_light_goes_on_from_glass_to_glass() -> None:
    """The spot reaches the first ball only; the second may pass on what it gets from there."""
    second = BALL.replace("name: ball", "name: second").replace("[0, 2, 0]", "[6, 2, 0]")
    found = names(make(FLOOR, BALL % "clear", second % "clear", lights=(LAMPS["spot_at"],)))
    assert found == {("lamp", "ball", "floor"), ("lamp", "second", "floor")}


def test_an_unseen_receiver_shows_no_caustic() -> None:
    """The camera sees a card far from the ball; the floor's part in the picture is the card's alone."""
    card = "{name: card, rectangle: {center: [50, 0, 0], u: [1, 0, 0], v: [0, 0, -1]}, material: %s}"
    table = "{name: table, rectangle: {center: [0, 0, 0], u: [3, 0, 0], v: [0, 0, -3]}, material: white}"
    camera = "{position: [50, 1, 0], look_at: [50, 0, 0], up: [0, 0, -1], fov_deg: 40}"
    assert names(make(table, BALL % "clear", card % "black", camera=camera)) == set()
    assert names(make(table, BALL % "clear", card % "white", camera=camera)) == {("sun", "ball", "card")}
    assert ("sun", "ball", "table") in names(make(table, BALL % "clear", card % "mirror", camera=camera))


BESIDE = "{name: card, rectangle: {center: [-2, 0, 0], u: [1, 0, 0], v: [0, 0, 1]}, material: white}"
FLAT_MIRROR = "{name: pool, rectangle: {center: [2, %s, 0], u: [1, 0, 0], v: [0, 0, 1]}, material: mirror}"


@pytest.mark.parametrize(("height", "reaches"), [("0", False), ("1e-9", True)])
def test_a_flat_mirror_lights_nothing_in_its_own_plane(height: str, reaches: bool) -> None:
    found = names(make(BESIDE, FLAT_MIRROR % height, lights=(LAMPS["sky"],)))
    assert found == ({("lamp", "pool", "card")} if reaches else set())
