"""A view shows its patch, whole and as fine as its metric needs, from where the scene's camera stands."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.plan.small_scenes import ball_over_floor
from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.camera import View
from vitrail.geometry.patch import corners_of
from vitrail.geometry.world import World
from vitrail.images.patch import make_grid
from vitrail.pipeline.job import prepare
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Quality
from vitrail.plan.views import (
    BARE,
    COARSE,
    EDGES,
    FINE,
    LEAST_MARGIN,
    MEANS,
    PIXELS,
    ROUGH,
    THIN,
    ObservationView,
    views_of,
)
from vitrail.scene.load import load, load_text
from vitrail.scene.model import Scene
from vitrail.scene.print import print_scene

SCENES = sorted((Path(__file__).parents[2] / "scenes").rglob("*.yaml"))
HIGH = "{position: [3, 8, 5], look_at: [0, 0, 0], fov_deg: 40}"
FLAT = "{kind: orthographic, position: [0, 9, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 8}"


def observation(name: str, center: str = "[0, 0, 0]", phenomenon: str = "caustic", u: str = "[0.5, 0, 0]") -> str:
    return f"{{name: {name}, phenomenon: {phenomenon}, patch: {{center: {center}, u: {u}, v: [0, 0, -0.5]}}}}"


WORLD = World.of_scene(ball_over_floor())
PLAN = analyse(WORLD)
"""A plan with a caustic: a view asks it for nothing else."""


def views(scene: Scene, **overrides: object) -> tuple[ObservationView, ...]:
    return views_of(World.of_scene(scene), PLAN, settings_for(WORLD, PLAN, **overrides))


def number(value: float) -> float:
    """A number that a scene file can hold without an exponent."""
    return round(value, 3)


def only_view(*observe: str, camera: str = HIGH) -> tuple[Scene, ObservationView]:
    scene = ball_over_floor(camera=camera, observe=observe)
    (view,) = views(scene)
    return scene, view


def corners_in(scene: Scene, view: ObservationView) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pixel coordinates and depths of the corners of the view's patch."""
    patch = next(entry.patch for entry in scene.observe if entry.name in view.observations)
    return View.of(view.camera, view.image).project(np.array(corners_of(patch)))


@settings(max_examples=40, deadline=None)
@given(
    eye=st.tuples(st.floats(-4, 4).map(number), st.floats(2.5, 9).map(number), st.floats(-4, 4).map(number)),
    centre=st.tuples(st.floats(-2, 2).map(number), st.floats(-2, 2).map(number)),
    turn=st.floats(0, math.pi),
    kind=st.sampled_from(["fov_deg: 60", "kind: orthographic, height: 9"]),
)
def test_a_patch_is_wholly_in_its_view_with_a_margin(
    eye: tuple[float, float, float], centre: tuple[float, float], turn: float, kind: str
) -> None:
    (x, z), c, s = centre, math.cos(turn), math.sin(turn)
    patch = f"{{center: [{x}, 0, {z}], u: [{c}, 0, {s}], v: [{-s / 3}, 0, {c / 3}]}}"
    camera = f"{{position: {list(eye)}, look_at: [0.1, 0, 0.1], up: [0, 1, 0.01], {kind}}}"
    scene, view = only_view(f"{{name: spot, phenomenon: caustic, patch: {patch}}}", camera=camera)
    x_px, y_px, depth = corners_in(scene, view)
    width, height = view.image.width, view.image.height
    assert (depth > 0).all()
    assert min(x_px.min(), y_px.min(), (width - x_px).min(), (height - y_px).min()) >= LEAST_MARGIN - 1e-6
    # One side of the patch, or the other, is as long as the picture but for the margin.
    assert max(np.ptp(x_px), np.ptp(y_px)) >= FINE / 2 - 1


def test_the_eye_stays_and_looks_at_the_middle() -> None:
    scene, view = only_view(observation("spot", "[1, 0, 2]"))
    assert view.camera.position == scene.camera.position
    assert view.camera.look_at == (1, 0, 2)
    assert (view.camera.up, view.camera.kind) == (scene.camera.up, scene.camera.kind)


def test_an_orthographic_camera_keeps_its_direction_and_is_moved_aside() -> None:
    scene, view = only_view(observation("spot", "[1, 0, 2]"), camera=FLAT)
    assert view.camera.position == (1, 9, 2)
    assert np.subtract(view.camera.look_at, view.camera.position).tolist() == [0, -9, 0]


def test_pixels_of_an_aligned_orthographic_view_are_the_cells_of_its_patch() -> None:
    scene, view = only_view(observation("spot", "[1, 0, 2]"), camera=FLAT)
    grid = make_grid(view.camera, view.image, scene.observe[0].patch)
    assert grid.coverage.shape == (FINE, FINE)
    assert grid.weights.nnz == FINE**2
    assert np.allclose(grid.weights.data, 1)


def test_a_view_is_as_fine_as_its_metric_needs_whatever_the_image_is() -> None:
    for phenomenon, pixels in PIXELS.items():
        along = ", along: u" if phenomenon is Phenomenon.DISPERSION else ""
        entry = observation("spot", phenomenon=phenomenon.value)[:-1] + along + "}"
        scene, view = only_view(entry, camera=FLAT)
        x_px, _, _ = corners_in(scene, view)
        assert np.ptp(x_px) == pytest.approx(pixels)


def test_a_thin_patch_has_pixels_across_it() -> None:
    scene, view = only_view(observation("spot", u="[0.05, 0, 0]"), camera=FLAT)
    x_px, _, _ = corners_in(scene, view)
    assert np.ptp(x_px) == pytest.approx(THIN)


def test_observations_of_one_patch_share_a_view_that_serves_the_finest() -> None:
    coarse, fine = observation("mean", phenomenon="diffusion"), observation("spot")
    other = observation("other", "[1, 0, 0]", phenomenon="diffusion")
    first, second = views(ball_over_floor(camera=FLAT, observe=(coarse, other, fine)))
    assert (first.name, first.observations) == ("mean", ("mean", "spot"))
    assert second.observations == ("other",)
    assert first.image.width == 2 * math.ceil(FINE / 16) + FINE
    assert second.image.width == 2 * math.ceil(COARSE / 16) + COARSE


@pytest.mark.parametrize("place", ["[3, 8, 5]", "[3, 8, 5.3]"], ids=["in the eye", "around the eye"])
def test_a_patch_that_the_eye_cannot_frame_keeps_the_scene_s_camera(place: str) -> None:
    scene, view = only_view(observation("spot", place))
    assert view.camera == scene.camera
    assert view.image.width % scene.image.width == view.image.height % scene.image.height == 0


def test_an_orthographic_patch_behind_the_picture_plane_keeps_the_scene_s_camera() -> None:
    scene, view = only_view(observation("spot", "[1, 20, 2]"), camera=FLAT)
    assert view.camera == scene.camera


def test_an_up_along_the_new_line_of_sight_gives_way() -> None:
    camera = "{position: [0, 5, 0], look_at: [3, 0, 0], fov_deg: 60}"
    scene, view = only_view(observation("spot", "[0, 0, 0]"), camera=camera)
    assert view.camera.look_at == (0, 0, 0)
    # What was up in the scene's picture, [5, 3, 0], still is.
    assert View.of(view.camera, view.image).up == pytest.approx((1, 0, 0))


def test_names_are_names_of_files() -> None:
    entries = (observation('"a/b"'), observation('"a b"', "[1, 0, 0]"), observation("c", "[2, 0, 0]"))
    assert [view.name for view in views(ball_over_floor(camera=HIGH, observe=entries))] == ["a_b", "a_b-1", "c"]


def test_a_caustic_has_the_samples_that_resolve_its_discs() -> None:
    scene = ball_over_floor(camera=FLAT, observe=(observation("spot"),))
    # A pixel of 1/128 and samples every 1.5 radii: 128 * 1.5 * radius = 1/5 asks for 25.
    (view,) = views(scene, gather_radius_m=1 / (5 * 1.5 * 128) * (1 + 1e-9), samples=4)
    assert view.samples == 25
    (draft,) = views(scene, gather_radius_m=1 / (3 * 1.5 * 128), quality=Quality.DRAFT)
    assert draft.samples == 1


@pytest.mark.parametrize(
    ("phenomenon", "samples"), [("diffusion", MEANS), ("refraction", EDGES), ("shadow", EDGES), ("roughness", ROUGH)]
)
def test_edges_have_more_samples_than_means(phenomenon: str, samples: int) -> None:
    scene = ball_over_floor(camera=FLAT, observe=(observation("spot", phenomenon=phenomenon),))
    world, caustic = World.of_scene(scene), PLAN.entries[Phenomenon.CAUSTIC]
    plain = replace(PLAN, entries={**PLAN.entries, Phenomenon.CAUSTIC: replace(caustic, required=False)})

    def samples_of(plan: Plan, **overrides: object) -> list[int]:
        return [view.samples for view in views_of(world, plan, settings_for(WORLD, PLAN, **overrides))]

    assert samples_of(plain, samples=4) == [samples]
    assert samples_of(plain, samples=100) == [100]
    assert samples_of(plain, quality=Quality.DRAFT, samples=4) == [4]
    # Where photons are gathered for each sample, what glass shows begins with as few as means; bare cards are cheap.
    assert samples_of(PLAN, samples=4) == [BARE if phenomenon == "diffusion" else MEANS]


def test_samples_of_the_image_are_for_people() -> None:
    figure = next(path for path in SCENES if path.stem == "figure_5")
    job = prepare(load(figure)).with_views()
    assert job.scene.image.samples == 1
    assert min(view.samples for view in job.views) == MEANS


def test_a_job_with_views_gathers_as_fine_as_its_patches_whatever_its_image() -> None:
    ball = next(path for path in SCENES if path.stem == "figure_2")
    plain = prepare(load(ball))
    job = plain.with_views()
    assert not plain.views
    assert [view.name for view in job.views] == [entry.name for entry in job.scene.observe]
    assert job.settings.gather_radius_m == pytest.approx(math.hypot(0.3, 0.3) / 120, rel=1 / 8)
    assert job.settings.gather_radius_m < plain.settings.gather_radius_m
    asked = prepare(load(ball), Quality.NORMAL, {"gather_radius_m": 0.25, "samples": 7}).with_views()
    assert (asked.settings.gather_radius_m, asked.settings.samples) == (0.25, 7)
    assert {view.samples for view in asked.views} == {7}
    assert (job.settings.branch_share, plain.settings.branch_share) == (1e-4, 0.01)


def test_what_only_a_view_is_fine_enough_to_show_is_required() -> None:
    """A spread of colours below a pixel of the picture is left out there, and many pixels wide in a view."""
    entry = observation("spot", u="[0.005, 0, 0]").replace("[0, 0, -0.5]", "[0, 0, -0.005]")
    scene = ball_over_floor("faint_flint", camera=HIGH, observe=(entry,))
    plain = prepare(load_text(print_scene(scene)))
    job = plain.with_views()
    assert not plain.plan.requires(Phenomenon.DISPERSION)
    assert job.plan.requires(Phenomenon.DISPERSION)
    assert job.plan.chain.transmissions >= plain.plan.chain.transmissions


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_every_scene_of_the_repository_frames_every_patch(path: Path) -> None:
    scene = load(path).scene
    for view in views(scene):
        x_px, y_px, depth = corners_in(scene, view)
        inside = (depth > 0) & (x_px > 0) & (y_px > 0) & (x_px < view.image.width) & (y_px < view.image.height)
        assert inside.all()
        assert view.image.width * view.image.height < 300**2
