"""Views in the translation: another camera and other samples, and everything else as in the scene's own picture."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from vitrail.base.changed import changed
from vitrail.base.vector import add
from vitrail.geometry.world import World
from vitrail.lower.povray import NotTranslatable, PovrayScene, lower_povray
from vitrail.pipeline.content_keys import povray_key
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.plan.views import ObservationView
from vitrail.scene.load import load

BALL = load(Path(__file__).parents[3] / "scenes" / "calibration" / "ball_lens.yaml")
WORLD = World.of(BALL)
PLAN = analyse(WORLD)


def view(*, samples: int = 9, away: float = 0.0) -> ObservationView:
    """A square picture of the scene's camera, ``away`` metres to the right of it."""
    camera = BALL.scene.camera
    moved = changed(camera, position=add(camera.position, (away, 0, 0)), look_at=add(camera.look_at, (away, 0, 0)))
    first = BALL.scene.observe[0].name
    return ObservationView("close", (first,), moved, changed(BALL.scene.image, width=24, height=24), samples)


def lowered(*views: ObservationView) -> PovrayScene:
    return lower_povray(WORLD, PLAN, settings_for(WORLD, PLAN, samples=4, photons=100_000), views)


def test_a_scene_without_views_is_written_as_with_them() -> None:
    alone, beside = lowered(), lowered(view())
    for without, having in zip(alone.runs, beside.runs, strict=True):
        assert having.photon_sdl == without.photon_sdl and having.sdl == without.sdl and having.gain == without.gain
        assert list(without.texts) == [f"{without.name}.photons.pov", f"{without.name}.pov"]
        assert list(having.texts) == [*without.texts, f"{having.name}.view.close.pov"]


def test_a_view_differs_from_the_scene_in_its_camera_alone() -> None:
    """Lights, bodies, depth and photons are word for word the same."""
    for run in lowered(view(away=0.5)).runs:
        own, close = run.pictures
        differing = [
            pair for pair in zip(own.text.splitlines(), close.text.splitlines(), strict=True) if len(set(pair)) > 1
        ]
        assert differing and all("location" in line or "right" in line or "up" in line for line in differing[0])
        assert len(differing) == 1
        assert (close.samples_across, close.samples_down) in ((3, 2), (2, 5))
        assert (close.width, close.height) == (24 * close.samples_across, 24 * close.samples_down)


def test_the_key_of_the_pictures_knows_the_views() -> None:
    keys = {
        povray_key("build", lowered(*views))
        for views in ((), (view(),), (view(samples=25),), (view(away=0.5),), (replace(view(), name="other"),))
    }
    assert len(keys) == 5


def test_a_view_from_too_far_away_is_refused_with_the_observation() -> None:
    with pytest.raises(NotTranslatable, match=r"ball_lens.yaml:\d+:\d+.*camera of this observation is too far"):
        lowered(view(away=1e7))
