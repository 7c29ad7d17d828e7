"""Views in the real POV-Ray: photons are shot once, and each picture is what its own camera sees, sample for sample."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, scene
from vitrail.base.changed import changed
from vitrail.engines.cache import Cache
from vitrail.engines.povray import Povray
from vitrail.geometry.world import World
from vitrail.images.exr import read_image
from vitrail.lower.povray import PovrayScene, lower_povray
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.plan.views import ObservationView
from vitrail.scene.load import Loaded

pytestmark = pytest.mark.povray

BALL = scene(
    "floor: {diffuse: 0.5}\nclear: {transmission: 1, ior: 1.5}",
    """
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: floor}
    - {name: ball, sphere: {center: [0, 0.8, 0], radius: 0.4}, material: clear}
    """,
    camera="camera: {kind: orthographic, position: [0, 0.3, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}",
)
CHECKS = scene(
    "checks: {diffuse: {checker: {colors: [[0.25, 0.25, 0.25], [0.75, 0.75, 0.75]], size: 1}}}",
    "- {name: floor, rectangle: {center: [0, 0, 0], u: [4, 0, 0], v: [0, 0, -4]}, material: checks}",
    camera="camera: {kind: orthographic, position: [0.5, 1, 0.5], look_at: [0.5, 0, 0.5], up: [0, 0, -1], height: 0.5}",
)


def view(loaded: Loaded, name: str, samples: int, *, aside: float = 0.0, width: int = 32) -> ObservationView:
    """The scene's own camera, moved to the right, with a picture of its own size."""
    own = loaded.scene.camera
    (x, y, z), (a, b, c) = own.position, own.look_at
    camera = changed(own, position=(x + aside, y, z), look_at=(a + aside, b, c))
    return ObservationView(name, (), camera, changed(loaded.scene.image, width=width, height=width), samples)


def lowered(loaded: Loaded, *views: ObservationView, **settings: object) -> PovrayScene:
    world = World.of(loaded)
    plan = analyse(world)
    return lower_povray(world, plan, settings_for(world, plan, **{"samples": 1, **settings}), views)


def test_photons_are_shot_once_and_serve_every_picture(tmp_path: Path) -> None:
    """A view like the scene's own picture is the same bits, and the scene's own does not notice the views."""
    same, fine = view(BALL, "same", 1), view(BALL, "photons", 4)
    alone = Povray().render(lowered(BALL, photons=20_000), tmp_path / "alone")
    made = Povray().render(lowered(BALL, same, fine, photons=20_000), tmp_path / "made")
    own = read_image(made.image_path).radiance
    assert own.max() > 1 and np.array_equal(own, read_image(alone.image_path).radiance)
    assert np.array_equal(own, read_image(made.views["same"]).radiance)
    # More samples a pixel change what a pixel sees of the spot's edge, and little else.
    fine_radiance = read_image(made.views["photons"]).radiance
    assert 0 < np.abs(fine_radiance - own).mean() < 0.05 * own.mean()
    assert made.record["counters"]["photons_emitted"] == alone.record["counters"]["photons_emitted"]
    assert [each["samples_used"] for each in made.record["views"]] == [1, 5]
    assert all(each["camera_rays"] >= 2 * 32 * 32 and each["cpu_s"]["total"] > 0 for each in made.record["views"])
    assert sorted(path.name for path in (tmp_path / "made").glob("*.exr")) == [
        "povray.exr",
        "povray.photons.exr",
        "povray.same.exr",
    ]


def test_a_view_shows_what_its_camera_sees(tmp_path: Path) -> None:
    """The next check to the right is three times as bright, and outside the scene's own picture."""
    made = Povray().render(lowered(CHECKS, view(CHECKS, "next", 1, aside=1.0, width=8)), tmp_path)
    own, beside = (read_image(path).radiance for path in (made.image_path, made.views["next"]))
    assert own.shape == (32, 32, 3) and beside.shape == (8, 8, 3)
    darker, brighter = sorted((float(own.mean()), float(beside.mean())))
    assert (darker, brighter) == pytest.approx((0.25, 0.75), rel=HALF_FLOAT)
    assert own.std() == beside.std() == 0


def test_programs_at_a_time_do_not_change_a_view(tmp_path: Path) -> None:
    views = [view(BALL, name, 1, aside=aside) for name, aside in (("left", -0.25), ("right", 0.25), ("far", 0.5))]
    made = [Povray().render(lowered(BALL, *views, photons=5_000), tmp_path / str(n), threads=n) for n in (1, 3)]
    for name in ("left", "right", "far"):
        first, second = (read_image(each.views[name]).radiance for each in made)
        assert np.array_equal(first, second)


def test_the_cache_keeps_views(tmp_path: Path) -> None:
    cache, wanted = Cache(tmp_path), lowered(CHECKS, view(CHECKS, "next", 1))
    made = cache.rendered("key", lambda folder: Povray().render(wanted, folder))
    kept = cache.find("key")
    assert kept is not None and kept.views == made.views and kept.views["next"].is_file()
    kept.views["next"].unlink()
    assert cache.find("key") is None
