"""A shape or a light stands in a file under the key of its type, and in the program in one field."""

from __future__ import annotations

from typing import get_args

import pytest
from pydantic import ValidationError

from vitrail.base.changed import changed
from vitrail.scene.colours import colour_keys, colours_of
from vitrail.scene.diagnostic import SceneErrors
from vitrail.scene.load import load_text
from vitrail.scene.model import Area, Disc, Emitter, Light, Object, Rectangle, Scene, Shape, Sphere

BALL = {"center": (0, 1, 0), "radius": 2}
SCENE = """
vitrail: 1
camera: {{position: [0, 1, 5], look_at: [0, 1, 0], fov_deg: 30}}
image: {{width: 16, height: 16}}
materials: {{white: {{diffuse: 0.5}}}}
objects:
  - {{name: ball, {}, material: white}}
lights:
  - {{name: lamp, {}}}
"""
SPHERE, POINT = "sphere: {center: [0, 1, 0], radius: 2}", "point: {position: [0, 9, 0], intensity: 1}"


def messages(shape: str = SPHERE, light: str = POINT) -> list[str]:
    with pytest.raises(SceneErrors) as raised:
        load_text(SCENE.format(shape, light))
    return [f"{each.line}:{each.col}: {each.what}; {each.remedy}" for each in raised.value.diagnostics]


def test_every_type_of_the_unions_has_a_key_of_its_own() -> None:
    for union in (Shape, Emitter):
        keys = [kind.key for kind in get_args(union)]
        assert len(set(keys)) == len(keys) and all(keys)
    assert Object.kinds()["sphere"] is Sphere and Area.kinds() == {"rectangle": Rectangle, "disc": Disc}


def test_a_shape_is_read_from_its_key_or_given_as_itself() -> None:
    written = Object.model_validate({"name": "ball", "material": "m", "sphere": BALL})
    assert written == Object(name="ball", material="m", shape=Sphere(center=(0, 1, 0), radius=2))
    assert [key for key, _ in written.entries()] == ["name", "material", "sphere"]


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        ("priority: 1", "an object has exactly one shape, this one has none; the shapes are sphere, plane,"),
        (f"{SPHERE}, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}", "this one has sphere and plane;"),
        (f"shape: {{{SPHERE}}}", "unknown key `shape` in `objects[0]`; the keys are name, material, sphere, plane,"),
        (f"{SPHERE}, shape: ball", "unknown key `shape`"),
        ("shpere: {center: [0, 1, 0], radius: 2}", "unknown key `shpere` in `objects[0]`; did you mean `sphere`?"),
        ("sphere: {center: [0, 1, 0], radius: -2}", "`radius` is -2 and must be above 0"),
        ("sphere: 3", "`sphere` must be a mapping"),
        ("sphere: null", "`sphere` has no value"),
    ],
)
def test_a_shape_that_is_none_is_told_in_the_words_of_the_file(shape: str, words: str) -> None:
    found = messages(shape=shape)
    assert len(found) == 1 and words in found[0], found


@pytest.mark.parametrize(
    ("light", "words"),
    [
        ("emitter: {point: 1}", "unknown key `emitter`"),
        ("area: {radiance: 1}", "an area light has exactly one shape, `rectangle` or `disc`; change it"),
        ("area: {shape: 3, radiance: 1}", "unknown key `shape` in `area`"),
        (
            "area: {disc: {center: [0, 9, 0], normal: [0, -1, 0], radius: 0}, radiance: 1}",
            "`radius` is 0 and must be above 0",
        ),
    ],
)
def test_a_light_that_is_none_is_told_in_the_words_of_the_file(light: str, words: str) -> None:
    found = messages(light=light)
    assert len(found) == 1 and words in found[0], found


def test_no_part_holds_two_shapes() -> None:
    ball = Object(name="ball", material="m", shape=Sphere(center=(0, 1, 0), radius=2))
    for fields in ({"sphere": BALL}, {"shape": None}, {"shape": Light}, {"shape": {"sphere": BALL}}):
        with pytest.raises((ValidationError, TypeError)):
            changed(ball, **fields)


def test_the_types_know_every_key_of_a_colour() -> None:
    """A key that is missing here would be printed at length; the schema says which keys take one number or three."""
    assert colour_keys() == {
        "absorption_per_m", "ambient", "color", "diffuse", "emission", "intensity", "irradiance", "radiance",
        "reflection", "transmission",
    }  # fmt: skip


def test_the_colours_of_a_scene_are_found_wherever_its_types_have_one() -> None:
    """Also in patterns and lights: one that is missed would let one channel stand for three in POV-Ray."""
    text = SCENE.format(
        SPHERE, "area: {rectangle: {center: [0, 9, 0], u: [1, 0, 0], v: [0, 0, 1]}, radiance: [7, 8, 9]}"
    )
    text = text.replace("diffuse: 0.5", "diffuse: {checker: {colors: [[0.1, 0.2, 0.3], 0.4], size: 1}}")
    scene: Scene = load_text(text).scene
    assert {(0.1, 0.2, 0.3), (0.4, 0.4, 0.4), (7.0, 8.0, 9.0)} <= set(colours_of(scene))
    assert all(len(colour) == 3 for colour in colours_of(scene))
