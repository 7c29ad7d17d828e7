"""The real tracer by way of the engine: progress, interruption, and the proof that a plan drops nothing."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from vitrail.check.check import check_file
from vitrail.engines.tracer import Tracer
from vitrail.geometry.world import World
from vitrail.images.exr import ImageLayers, read_image
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import analyse, everything
from vitrail.plan.budget import settings_for
from vitrail.plan.plan import Plan
from vitrail.plan.views import ObservationView
from vitrail.scene.load import load_text
from vitrail.scene.model import Image, Scene

pytestmark = [pytest.mark.tracer, pytest.mark.slow]

ROOT = Path(__file__).parents[2]
SCENES = sorted((ROOT / "scenes").glob("*/*.yaml"))
PHOTONS = 20_000


def small(path: Path) -> Scene:
    """A scene of the project in a picture of 32 pixels a side at most."""
    scene = check_file(path).scene_or_raise().scene
    shrink = 32 / max(scene.image.width, scene.image.height)
    size = {"width": max(1, round(scene.image.width * shrink)), "height": max(1, round(scene.image.height * shrink))}
    return scene.model_copy(update={"image": Image(**size)})


def rendered(scene: Scene, plan: Plan, photons: int, folder: Path, source: Path) -> ImageLayers:
    world = World.of_scene(scene, source.parent)
    radius = settings_for(world, analyse(world)).gather_radius_m
    settings = settings_for(world, plan, "draft", photons=photons, gather_radius_m=radius)
    return read_image(Tracer().render(lower_tracer(world, plan, settings), folder).image_path)


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_everything_on_gives_the_same_image_as_the_plan(path: Path, tmp_path: Path) -> None:
    """To the last bit: random numbers are functions of photon and pixel, so more work elsewhere disturbs none."""
    scene = small(path)
    world = World.of_scene(scene)
    plan, most = analyse(world), everything(world)
    # The budget gives photons to caustics and to indirect light, and none to anything else.
    photons = PHOTONS if settings_for(world, plan, "draft").photons else 0
    needed = rendered(scene, plan, photons, tmp_path / "needed", path)
    full = rendered(scene, most, PHOTONS, tmp_path / "full", path)
    np.testing.assert_array_equal(needed.radiance, full.radiance)


@pytest.mark.parametrize("bands", ["paper", "povray", "{spectral: 5}", "continuous"])
def test_white_stays_white_in_every_band_model(bands: str, tmp_path: Path) -> None:
    """A dispersive pane that mirrors nothing, at normal incidence, spreads nothing: a panel of radiance 1 shows 1."""
    loaded = load_text(f"""
vitrail: 1
camera: {{kind: orthographic, position: [0, 0, 2], look_at: [0, 0, 0], height: 0.1}}
image: {{width: 2, height: 2}}
transport: {{bands: {bands}}}
materials: {{panel: {{emission: 1}}, glass: {{transmission: 1, ior: 1.6, dispersion: 0.03}}}}
objects:
  - {{name: panel, rectangle: {{center: [0, 0, -1], u: [1, 0, 0], v: [0, 1, 0]}}, material: panel}}
  - {{name: pane, box: {{min: [-1, -1, 0], max: [1, 1, 0.1]}}, material: glass}}
lights: []
""")
    scene = loaded.scene
    image = rendered(scene, everything(World.of_scene(scene)), 0, tmp_path, loaded.path)
    # Weights are multiples of 2^-40; the image is kept in single precision.
    np.testing.assert_allclose(image.radiance, 1, rtol=2**-23)


def test_views_come_from_the_photons_of_the_picture_and_leave_it_as_it_is(tmp_path: Path) -> None:
    scene = small(ROOT / "scenes" / "calibration" / "ball_lens.yaml")
    world = World.of_scene(scene)
    plan = analyse(world)
    settings = settings_for(world, plan, "draft", photons=PHOTONS)
    views = (
        ObservationView("same", ("a",), scene.camera, scene.image, settings.samples),
        ObservationView("finer", ("b",), scene.camera, Image(width=48, height=48), 4),
    )
    alone = Tracer().render(lower_tracer(world, plan, settings), tmp_path / "alone")
    made = Tracer().render(lower_tracer(world, plan, settings, views=views), tmp_path / "viewed")
    picture = read_image(made.image_path)
    np.testing.assert_array_equal(picture.radiance, read_image(alone.image_path).radiance)
    np.testing.assert_array_equal(picture.radiance, read_image(made.views["same"]).radiance)
    finer = read_image(made.views["finer"])
    assert finer.radiance.shape == (48, 48, 3)
    assert finer.metadata["vitrail:view"] == "finer"
    assert json.loads(finer.metadata["vitrail:settings"])["samples"] == 4
    assert [view["name"] for view in made.record["views"]] == ["same", "finer"]
    assert all(view["camera_rays"] > 0 and view["cpu_s"]["camera"] >= 0 for view in made.record["views"])
    assert made.record["counters"]["photons_stored"] == alone.record["counters"]["photons_stored"]


def test_progress_tells_the_phases(tmp_path: Path) -> None:
    scene = small(ROOT / "scenes" / "calibration" / "ball_lens.yaml")
    world = World.of_scene(scene)
    plan = analyse(world)
    settings = settings_for(world, plan, "draft")
    steps: list[tuple[str, float, float]] = []
    lowered = lower_tracer(world, plan, settings)
    Tracer().render(lowered, tmp_path, progress=lambda *step: steps.append(step))
    assert {phase for phase, _, _ in steps} >= {"photon_pass", "camera"}
    assert all(0 <= done <= total for _, done, total in steps)


INTERRUPTED = """
import sys
from pathlib import Path
from tests.engines.test_tracer_render import *
scene = check_file(ROOT / "scenes" / "paper" / "figure_1.yaml").scene_or_raise().scene
world = World.of_scene(scene)
plan = analyse(world)
settings = settings_for(world, plan, "draft", samples=256, photons=0)
told = []
def progress(phase, done, total):
    if phase == "camera" and done >= 1 and not told:
        told.append(True)
        print("under way", flush=True)
made = Tracer().render(lower_tracer(world, plan, settings), Path(sys.argv[1]), threads=1, progress=progress)
print("interrupted", made.interrupted, made.image_path.is_file(), flush=True)
"""


def test_ctrl_c_leaves_an_image_of_the_finished_work(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT / "compare"), str(ROOT)))}
    command = [sys.executable, "-c", INTERRUPTED, str(tmp_path)]
    caller = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment, cwd=ROOT)
    assert caller.stdout is not None
    assert caller.stdout.readline() == "under way\n"
    caller.send_signal(signal.SIGINT)
    assert caller.stdout.read() == "interrupted True True\n"
    assert caller.wait() == 0
    assert np.isfinite(read_image(tmp_path / "tracer.exr").radiance).all()


def test_a_traced_ray_has_the_vertices_of_snell() -> None:
    """Height 0.5 over a ball of radius 1, index 1.5: sin i = 0.5, sin r = 1/3, leaving turned by 2 (i - r)."""
    scene = check_file(ROOT / "tests" / "golden" / "plain.yaml").scene_or_raise().scene
    world = World.of_scene(scene)
    plan = everything(world)
    lowered = lower_tracer(world, plan, settings_for(world, plan, "draft"))
    vertices = Tracer().trace(lowered, ["--origin", "0.5,4,0", "--direction", "0,-1,0"])["vertices"]
    assert [vertex["object"] for vertex in vertices] == ["ball", "ball", "floor"]
    turned = 2 * (np.arcsin(0.5) - np.arcsin(1 / 3))
    assert vertices[1]["direction_out"] == pytest.approx([-np.sin(turned), -np.cos(turned), 0], abs=1e-14)
