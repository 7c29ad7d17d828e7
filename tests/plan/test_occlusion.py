"""A shadow is never denied where a ray from light to receiver meets the occluder, and denied in plain cases."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.plan.small_scenes import FLOOR, SUN, ball_over_floor, make
from vitrail.geometry.world import World
from vitrail.plan.occlusion import may_shadow

coordinate = st.floats(-4, 4).map(lambda value: round(value, 2))
point = st.tuples(coordinate, coordinate, coordinate)
radius = st.floats(0.1, 1.5).map(lambda value: round(value, 2))

LAMP = "{name: lamp, point: {position: [%g, %g, %g], intensity: 1}}"
TILTED = "{name: sun, directional: {direction: [%g, %g, %g], irradiance: 1}}"
DISC = "{name: lamp, area: {disc: {center: [%g, %g, %g], normal: [0, -1, 0], radius: 0.5}, radiance: 1}}"
BALL = "{name: %s, sphere: {center: [%g, %g, %g], radius: %g}, material: white}"


@pytest.mark.slow
@settings(max_examples=400, deadline=None)
@given(
    light=st.sampled_from([LAMP, TILTED, DISC]),
    place=point.filter(any),
    receiver=st.tuples(point, radius),
    occluder=st.tuples(point, radius),
    on_floor=st.booleans(),
)
def test_a_shadow_that_some_ray_finds_is_never_denied(
    light: str, place: tuple, receiver: tuple, occluder: tuple, on_floor: bool
) -> None:
    target = FLOOR.replace("floor", "target") if on_floor else BALL % ("target", *receiver[0], receiver[1])
    scene = make(target, BALL % ("wall", *occluder[0], occluder[1]), lights=(light % place,))
    rng = np.random.default_rng(0)
    # Points on the receiver, and for each a point of the light; 60 steps from one to the other find the occluder.
    if on_floor:
        starts = rng.uniform(-6, 6, (300, 3)) * [1, 0, 1]
    else:
        normals = rng.normal(size=(300, 3))
        starts = np.array(receiver[0]) + receiver[1] * normals / np.linalg.norm(normals, axis=1, keepdims=True)
    if light is TILTED:
        ends = starts - 20 * np.array(place) / np.linalg.norm(place)
    else:
        spread = rng.uniform(-0.35, 0.35, (300, 3)) * [1, 0, 1] if light is DISC else 0.0
        ends = np.array(place) + spread * np.ones((300, 3))
    # On the floor only light from the seen side counts; on a ball only what arrives at its face.
    facing = ends[:, 1] > 0 if on_floor else ((ends - starts) * (starts - np.array(receiver[0]))).sum(axis=1) > 0
    steps = np.linspace(0.01, 1, 60)[None, :, None]
    way = (starts[facing, None, :] * (1 - steps) + ends[facing, None, :] * steps).reshape(-1, 3)
    blocked = len(way) > 0 and bool((World.of_scene(scene).solids[1].depth(way) > 0).any())
    assert may_shadow(World.of_scene(scene), scene.lights[0], scene.objects[0], scene.objects[1]) or not blocked


@pytest.mark.parametrize(
    ("light", "wall"),
    [
        (SUN, "{name: wall, sphere: {center: [0, -3, 0], radius: 1}, material: white}"),  # under the floor
        (LAMP % (0, 3, 0), "{name: wall, sphere: {center: [0, 6, 0], radius: 1}, material: white}"),  # above the lamp
        (SUN, "{name: wall, plane: {point: [0, -1, 0], normal: [0, 1, 0]}, material: white}"),
    ],
)
def test_nothing_below_the_floor_or_above_the_lamp_shadows_it(light: str, wall: str) -> None:
    card = "{name: card, rectangle: {center: [0, 0, 0], u: [2, 0, 0], v: [0, 0, -2]}, material: white}"
    for receiver in (FLOOR, card):
        if receiver is FLOOR and "plane" in wall:
            continue
        scene = make(receiver, wall, lights=(light,))
        assert not may_shadow(World.of_scene(scene), scene.lights[0], scene.objects[0], scene.objects[1])


def test_the_walls_of_a_room_do_not_shadow_each_other() -> None:
    room = make(
        "{name: floor, rectangle: {center: [0, 0, 0], u: [2, 0, 0], v: [0, 0, -2]}, material: white}",
        "{name: left, rectangle: {center: [-2, 2, 0], u: [0, 2, 0], v: [0, 0, -2]}, material: white}",
        "{name: ceiling, rectangle: {center: [0, 4, 0], u: [2, 0, 0], v: [0, 0, 2]}, material: white}",
        lights=(LAMP % (0, 3, 0),),
    )
    assert not any(may_shadow(World.of_scene(room), room.lights[0], a, b) for a in room.objects for b in room.objects)


def test_balls_beside_the_light_shadow_nothing() -> None:
    scene = make(BALL % ("target", 0, 0, 0, 1), BALL % ("wall", 5, 5, 0, 1), lights=(LAMP % (0, 5, 0),))
    assert not may_shadow(World.of_scene(scene), scene.lights[0], scene.objects[0], scene.objects[1])


def test_glass_shadows_itself_and_an_opaque_ball_does_not() -> None:
    for material, itself in (("clear", True), ("white", False)):
        scene = ball_over_floor(material)
        assert may_shadow(World.of_scene(scene), scene.lights[0], scene.objects[1], scene.objects[1]) is itself
