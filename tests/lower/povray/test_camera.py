"""Where the camera looks: pixel (i + 1/2, j + 1/2) of POV-Ray's image is that of the scene, by a right-handed eye."""

from __future__ import annotations

import numpy as np
import pytest

from tests.lower.povray.real_povray import rendered, scene
from vitrail.geometry.placement import place
from vitrail.geometry.surface import checker_index
from vitrail.geometry.world import World
from vitrail.scene.load import Loaded

pytestmark = pytest.mark.povray

CAMERAS = {
    "perspective": "camera: {position: [3, 2, 4], look_at: [0.5, 0.2, -0.3], up: [0.2, 1, 0.1], fov_deg: 47}",
    "orthographic": (
        "camera: {kind: orthographic, position: [-3, 2, 4], look_at: [0, 0, 0], up: [0, 1, 0], height: 3.2}"
    ),
}
POINTS = [(0.9, 0.1, 0.2), (-0.4, 0.8, 0.1), (0.2, -0.5, 0.9)]
COLOURS = ["[4, 0, 0]", "[0, 4, 0]", "[0, 0, 4]"]


def glowing_balls(camera: str) -> Loaded:
    """Three small balls, each in its own colour, on black."""
    materials = "\n".join(f"m{k}: {{emission: {colour}}}" for k, colour in enumerate(COLOURS))
    objects = "\n".join(
        f"- {{name: b{k}, sphere: {{center: {list(point)}, radius: 0.06}}, material: m{k}}}"
        for k, point in enumerate(POINTS)
    )
    return scene(materials, objects, lights="", camera=camera, image="image: {width: 90, height: 60}")


@pytest.mark.parametrize("kind", CAMERAS)
def test_balls_are_seen_where_the_scene_projects_them(kind: str) -> None:
    """The brightness-weighted middle of a ball's image; 0.05 pixels: its few hundred samples, and perspective."""
    loaded = glowing_balls(CAMERAS[kind])
    image = rendered(loaded, samples=32).image.radiance
    rows, columns = np.mgrid[0:60, 0:90] + 0.5
    for channel, point in enumerate(POINTS):
        seen = World.of(loaded).view.sight(point)
        weight = image[..., channel] / image[..., channel].sum()
        assert (weight * columns).sum() == pytest.approx((seen.x + 1) * 45, abs=0.05)
        assert (weight * rows).sum() == pytest.approx((1 - seen.y) * 30, abs=0.05)


def test_halves_differ_by_noise_alone() -> None:
    """An edge through a column at a third of it: nothing is random, so both halves are the same picture."""
    objects = "- {name: card, rectangle: {center: [0.5333, 0, 0], u: [0.5, 0, 0], v: [0, 0, -9]}, material: glow}"
    camera = "camera: {kind: orthographic, position: [0, 1, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.5}"
    image = rendered(
        scene("glow: {emission: 1}", objects, lights="", camera=camera, image="image: {width: 5, height: 5}")
    ).image
    assert image.half_a == pytest.approx(image.half_b, abs=0)
    assert not image.variance.any()


def test_a_checker_lies_where_the_surface_coordinates_say() -> None:
    """On a plane seen from above: squares of 0.5 whose first colour covers s, t in [0, 0.5)."""
    material = "floor: {diffuse: {checker: {colors: [[0.8, 0, 0], [0, 0.8, 0]], size: 0.5}}}"
    objects = "- {name: floor, plane: {point: [0.1, 0, 0.2], normal: [0, 1, 0]}, material: floor}"
    camera = "camera: {kind: orthographic, position: [0, 1, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 4}"
    loaded = scene(material, objects, camera=camera, image="image: {width: 40, height: 40}")
    image = rendered(loaded).image.radiance
    floor = place(loaded.scene.objects[0]).surface_frame
    for row in range(40):
        for column in range(40):
            x, z = (column + 0.5) * 0.1 - 2, (row + 0.5) * 0.1 - 2
            s, t = floor.coordinates((x, 0.0, z))
            # Leave out pixels within a tenth of an edge.
            if min(s / 0.5 % 1, t / 0.5 % 1) < 0.1 or max(s / 0.5 % 1, t / 0.5 % 1) > 0.9:
                continue
            index = checker_index(s, t, 0.5)
            assert image[row, column, index] == pytest.approx(0.8, rel=1e-3)
            assert image[row, column, 1 - index] == 0


FLAT_SHAPES = [
    "rectangle: {center: [0, 0, 0], u: [0, 0, 1], v: [1, 0, 0]}",
    "disc: {center: [0, 0, 0], normal: [0, -1, 0], radius: 1.5}",
]


@pytest.mark.parametrize("turn", ["[0, 0, 0]", "[25, 40, -15]"])
@pytest.mark.parametrize("shape", FLAT_SHAPES)
def test_a_checker_on_other_flat_shapes_keeps_their_coordinates(shape: str, turn: str) -> None:
    material = "floor: {diffuse: {checker: {colors: [[0.8, 0, 0], [0, 0.8, 0]], size: 0.3}}}"
    loaded = scene(
        material,
        f"- {{name: floor, {shape}, rotate_deg: {turn}, translate: [0.05, 0, -0.1], material: floor}}",
        "- {name: a, directional: {direction: [0, -1, 0], irradiance: 3.14159265}}",
        "camera: {kind: orthographic, position: [0, 3, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1.6}",
    )
    image, flat = rendered(loaded).image.radiance, place(loaded.scene.objects[0]).surface_frame
    normal, middle = flat.normal, flat.origin
    for row in range(32):
        for column in range(32):
            # Look straight down onto the turned surface.
            x, z = (column + 0.5) * 0.05 - 0.8, (row + 0.5) * 0.05 - 0.8
            aside = normal[0] * (x - middle[0]) + normal[2] * (z - middle[2])
            s, t = flat.coordinates((x, middle[1] - aside / normal[1], z))
            if (
                min(s / 0.3 % 1, t / 0.3 % 1) > 0.1
                and max(s / 0.3 % 1, t / 0.3 % 1) < 0.9
                and max(abs(s), abs(t)) < 0.9
            ):
                index = checker_index(s, t, 0.3)
                assert image[row, column, index] > 0.5 and image[row, column, 1 - index] == 0
