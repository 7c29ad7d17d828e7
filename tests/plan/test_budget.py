"""Settings follow quality and scene, scale with it to the last bit, and refuse what makes no sense."""

from __future__ import annotations

import math

import pytest

from tests.plan.small_scenes import FLOOR, ball_over_floor, make
from vitrail.geometry.world import World
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import load_text
from vitrail.scene.model import Scene

SPOT = "{name: spot, phenomenon: caustic, patch: {center: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1]}}"


def ball_lens(scale: float, observe: bool) -> str:
    """The ball over its floor with all lengths times ``scale``."""
    spot = (
        f"observe:\n  - {{name: spot, phenomenon: caustic, patch: {{center: [0, 0, 0],"
        f" u: [{0.3 * scale!r}, 0, 0], v: [0, 0, {0.4 * scale!r}]}}}}\n"
    )
    return f"""
vitrail: 1
camera: {{position: [0, {8 * scale!r}, 0], look_at: [0, 0, 0], up: [0, 0, -1], fov_deg: 40}}
image: {{width: 64, height: 64}}
materials: {{white: {{diffuse: 0.8}}, clear: {{transmission: 1, ior: 1.5}}}}
objects:
  - {{name: floor, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: white}}
  - {{name: ball, sphere: {{center: [0, {2.1 * scale!r}, 0], radius: {0.7 * scale!r}}}, material: clear}}
lights:
  - {{name: sun, directional: {{direction: [0, -1, 0], irradiance: 3}}}}
""" + (spot if observe else "")


@pytest.mark.parametrize("observe", [True, False])
@pytest.mark.parametrize("quality", ["draft", "normal", "reference"])
def test_the_gather_radius_scales_exactly_with_the_scene(observe: bool, quality: str) -> None:
    small, large = (load_text(ball_lens(scale, observe)).scene for scale in (1.0, 8.0))
    worlds = [World.of_scene(scene) for scene in (small, large)]
    radii = [settings_for(world, analyse(world), quality).gather_radius_m for world in worlds]  # type: ignore
    assert radii[1] == 8 * radii[0]


def test_the_gather_radius_follows_the_smallest_caustic_patch() -> None:
    """Half diagonal of a patch of half edges 1: sqrt 2 / 120 = 0.01179, to three bits of mantissa 0.01172."""
    scene = of_size(ball_over_floor(observe=(SPOT,)), 2048)
    world = World.of_scene(scene)
    assert settings_for(world, analyse(world)).gather_radius_m == 0.01171875


def test_the_gather_radius_is_half_a_pixel_of_a_coarse_picture() -> None:
    """Nothing finer shows; then a pixel needs no more samples than usual to find it."""
    scene = of_size(ball_over_floor(observe=(SPOT,)), 64)
    world = World.of_scene(scene)
    settings = settings_for(world, analyse(world))
    pixel_m = 2 * 8 * math.tan(math.radians(20)) / 64
    assert settings.gather_radius_m == pytest.approx(pixel_m / 2, rel=1 / 16)  # three bits of mantissa
    assert settings.samples == 4


def of_size(scene: Scene, pixels: int) -> Scene:
    return scene.model_copy(update={"image": scene.image.model_copy(update={"width": pixels, "height": pixels})})


def test_fewer_photons_gather_from_farther() -> None:
    scene = ball_over_floor(observe=(SPOT,))
    world = World.of_scene(scene)
    radii = [settings_for(world, analyse(world), quality).gather_radius_m for quality in ("draft", "reference")]  # type: ignore
    assert radii[0] / radii[1] == pytest.approx(100 ** (1 / 6), rel=0.13)  # two roundings to 1/16


def test_quality_sets_samples_and_photons() -> None:
    scene = ball_over_floor()
    world = World.of_scene(scene)
    levels = [settings_for(world, analyse(world), quality) for quality in ("draft", "normal", "reference")]  # type: ignore
    assert [level.samples for level in levels] == [1, 4, 64]
    assert [level.photons for level in levels] == [100_000, 1_000_000, 10_000_000]


def test_a_scene_about_its_samples_has_them_at_every_quality() -> None:
    text = ball_lens(1.0, observe=True).replace("height: 64}", "height: 64, samples: 3}")
    world = World.of_scene(load_text(text).scene)
    plan = analyse(world)
    assert {settings_for(world, plan, quality).samples for quality in ("draft", "normal", "reference")} == {3}  # type: ignore
    assert settings_for(world, plan, "normal", samples=8).samples == 8


def test_a_fine_caustic_gets_the_samples_that_resolve_it() -> None:
    """A pixel of this camera covers 8 * 2 tan(20 deg) / 64 = 91 mm, and a sample 1.5 gather radii."""
    scene = load_text(ball_lens(1.0, observe=True)).scene
    world = World.of_scene(scene)
    plan = analyse(world)
    coarse, fine = (settings_for(world, plan, "normal", gather_radius_m=radius) for radius in (0.05, 0.012))
    assert coarse.samples == 4, "the radius is seen by the samples of the quality"
    assert fine.samples == math.ceil((8 * 2 * math.tan(math.radians(20)) / 64 / 0.018) ** 2) == 26
    assert settings_for(world, plan, "normal", gather_radius_m=0.001).samples == 32, "there is a limit"
    assert settings_for(world, plan, "draft", gather_radius_m=0.01).samples == 1, "a draft is a draft"
    assert settings_for(world, plan, "normal", gather_radius_m=0.01, samples=2).samples == 2


def test_no_caustic_and_no_indirect_light_mean_no_photons() -> None:
    scene = make(FLOOR)
    world = World.of_scene(scene)
    assert settings_for(world, analyse(world)).photons == 0
    scene = ball_over_floor("clear", lights=())
    assert settings_for(world, analyse(world), "reference").photons == 0


def test_overrides_are_taken_as_text_and_as_numbers() -> None:
    scene = ball_over_floor()
    world = World.of_scene(scene)
    settings = settings_for(
        world,
        analyse(world),
        photons="2e5",
        samples=9,
        gather_radius_m="0.5",
        solver="light_bins",
    )
    assert (settings.photons, settings.samples, settings.gather_radius_m) == (200_000, 9, 0.5)
    assert settings.solver == "light_bins"
