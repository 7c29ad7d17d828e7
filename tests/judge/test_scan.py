"""What the scan says of a whole picture: place, object, layer, patch, and when it is a deviation."""

import numpy as np
import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.seen import seen_object
from vitrail.geometry.world import World
from vitrail.images.exr import ImageLayers
from vitrail.judge.comparison import Verdict
from vitrail.judge.scan import scan_images
from vitrail.judge.scan_words import corner
from vitrail.scene.load import load_text

SCENE = """
vitrail: 1
title: a ball on a table
camera: {kind: orthographic, position: [0, 4, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 4}
image: {width: 80, height: 80}
materials:
  white: {diffuse: 0.8}
objects:
  - {name: table, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: white}
  - {name: ball, sphere: {center: [1, 0.5, 1], radius: 0.5}, material: white}
lights:
  - {name: sun, directional: {direction: [0, -1, 0], irradiance: 1}}
observe:
  - {name: middle, phenomenon: diffusion, patch: {center: [0, 0, 0], u: [0.5, 0, 0], v: [0, 0, -0.5]}}
"""
LIGHT = 0.25


@pytest.fixture
def world() -> World:
    return World.of(load_text(SCENE))


def image(seed: int, rows: slice = slice(0, 0), columns: slice = slice(0, 0), factor: float = 1.0) -> ImageLayers:
    """Even light with a percent of noise, ``factor`` times as bright in a box; all of it in the layer diffusion."""
    light = np.full((80, 80, 1), LIGHT)
    light[rows, columns] *= factor
    draw = np.random.default_rng(seed)
    halves = [light * (1 + 0.01 * draw.standard_normal((80, 80, 1))) * np.ones(3) for _ in range(2)]
    mean = (halves[0] + halves[1]) / 2
    return ImageLayers(mean, *halves, layers={"diffusion": mean, "caustic": np.zeros_like(mean)})


def nothing_stated(phenomenon: Phenomenon, whole_over_light: float) -> float:
    return 0.0


def scanned(world, *box, stated=nothing_stated, place=None):
    found = scan_images(world, {"tracer": image(1, *box), "povray": image(2)}, stated, place)
    assert found is not None
    return found


def test_equal_pictures_have_no_place(world, tmp_path):
    (tmp_path / "scene").mkdir()
    found = scanned(world, place=tmp_path / "scene")
    assert (found.places, found.more, found.verdict) == ((), 0, Verdict.AGREES)
    assert found.picture == "scene/over_noise.png" and (tmp_path / found.picture).is_file()


def test_a_place_is_named_with_its_object_and_its_layer(world):
    # The ball lies at x = z = 1 of 4 metres, that is at pixel 60 of 80 both ways.
    found = scanned(world, slice(50, 70), slice(50, 70), 1.7)
    (place,) = found.places
    assert (place.object, place.layer, place.observations) == ("ball", "diffusion", ())
    assert abs(place.x_px - 60) <= 2 and abs(place.y_px - 60) <= 2
    assert place.words.startswith("outside the patches: ")
    assert place.words.endswith("at the lower right, on `ball`, are 1.7 times brighter in the tracer (layer diffusion)")
    assert place.deviates and found.verdict is Verdict.DEVIATES


def test_a_small_difference_is_a_warning(world):
    found = scanned(world, slice(4, 20), slice(4, 24), 1.08)
    (place,) = found.places
    assert "at the upper left, on `table`, are" in place.words and "% brighter in the tracer" in place.words
    assert not place.deviates and found.verdict is Verdict.AGREES


def test_what_a_patch_holds_is_left_to_its_numbers(world):
    found = scanned(world, slice(34, 46), slice(34, 46), 1.7)
    (place,) = found.places
    assert place.observations == ("middle",) and place.words.startswith("inside `middle`: ")
    assert not place.deviates and found.verdict is Verdict.AGREES


def test_what_the_certificate_states_of_a_layer_is_allowed(world):
    box = slice(4, 20), slice(4, 24), 1.08
    assert not scanned(world, *box, stated=lambda p, w: 0.1 if p is Phenomenon.SHADOW else 0.0).places
    assert scanned(world, *box, stated=lambda p, w: 0.1 if p is Phenomenon.CAUSTIC else 0.0).places


def test_a_picture_without_halves_is_not_scanned(world):
    bare = ImageLayers(np.full((80, 80, 3), LIGHT))
    assert scan_images(world, {"tracer": image(1), "povray": bare}, nothing_stated) is None
    assert scan_images(world, {"tracer": image(1)}, nothing_stated) is None


def test_the_words_for_a_place_go_by_thirds():
    assert corner(45, 45, 90, 90) == "in the middle" and corner(80, 40, 90, 90) == "at the right"
    assert corner(45, 5, 90, 90) == "at the top" and corner(5, 80, 90, 90) == "at the lower left"


def test_a_ray_meets_what_is_first(world):
    assert seen_object(world, world.view, 60.5, 60.5) == "ball"
    assert seen_object(world, world.view, 10, 10) == "table"


def test_a_ray_that_meets_nothing_says_so():
    text = SCENE.replace(
        "position: [0, 4, 0], look_at: [0, 0, 0], up: [0, 0, -1]", "position: [0, 4, 0], look_at: [0, 5, 1]"
    )
    world = World.of(load_text(text))
    assert seen_object(world, world.view, 40, 40) == ""


def test_a_plane_is_met_at_the_horizon():
    text = SCENE.replace(
        "kind: orthographic, position: [0, 4, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 4",
        "position: [0, 1, 6], look_at: [0, 0.9, 0], fov_deg: 40",
    )
    world = World.of(load_text(text))
    assert seen_object(world, world.view, 40, 40) == "table" and seen_object(world, world.view, 40, 20) == ""
