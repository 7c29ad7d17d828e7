"""What a plan spares is not done: the tracer's counters and ledger, and the text that POV-Ray is given, prove it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.plan.small_scenes import FLOOR, ball_over_floor, make
from vitrail.engines.tracer import Tracer
from vitrail.geometry.world import World
from vitrail.images.exr import read_image
from vitrail.lower.povray import lower_povray
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.model import Scene

pytestmark = pytest.mark.tracer

AWAY = "{position: [0, 0.2, 40], look_at: [0, 0.2, 80], fov_deg: 10}"


def render(scene: Scene, folder: Path) -> tuple[dict[str, Any], dict[str, Any], set[str]]:
    """The lowered scene, the run record, and the layers of the image."""
    world = World.of_scene(scene)
    plan = analyse(world)
    lowered = lower_tracer(world, plan, settings_for(world, plan, "draft"))
    made = Tracer().render(lowered, folder)
    return lowered, made.record, set(read_image(made.image_path).layers)


def test_a_floor_alone_costs_neither_photons_nor_shadow_rays(tmp_path: Path) -> None:
    lowered, record, layers = render(make(FLOOR), tmp_path)
    assert record["counters"]["photons_emitted"] == 0
    assert record["counters"]["gather_queries"] == 0
    assert record["counters"]["shadow_rays"] == 0
    assert record["ledger"]["emitted"] == [0, 0, 0]
    assert layers == {"diffusion"}
    assert lowered["settings"]["photons"] == 0


def test_a_ball_over_a_floor_costs_both(tmp_path: Path) -> None:
    _, record, layers = render(ball_over_floor(), tmp_path)
    assert record["counters"]["photons_stored"] > 0
    assert record["counters"]["gather_queries"] > 0
    assert record["counters"]["shadow_rays"] > 0
    assert "caustic" in layers
    assert "reflection" not in layers


def test_glass_that_no_visible_path_meets_costs_nothing(tmp_path: Path) -> None:
    """The camera looks at the far floor, away from a lamp whose beam lights the ball alone: no light leads to it."""
    beam = "{name: lamp, spot: {position: [30, 6, 0], direction: [0, -1, 0], intensity: 1, cone_deg: 5}}"
    lowered, record, layers = render(ball_over_floor("flint", camera=AWAY, lights=(beam,)), tmp_path)
    assert record["counters"]["photons_emitted"] == 0
    assert len(lowered["bands"]) == 1
    assert layers == {"diffusion"}


@pytest.mark.parametrize(("material", "bands"), [("clear", 1), ("barely_flint", 1), ("flint", 4)])
def test_bands_are_run_only_for_colours_that_part(material: str, bands: int, tmp_path: Path) -> None:
    lowered, _, _ = render(ball_over_floor(material), tmp_path)
    assert len(lowered["bands"]) == bands


def test_roughness_below_the_error_is_not_sampled(tmp_path: Path) -> None:
    faint, _, _ = render(ball_over_floor("barely_frosted"), tmp_path / "faint")
    rough, _, _ = render(ball_over_floor("frosted"), tmp_path / "rough")
    assert [material["roughness"]["kind"] for material in faint["materials"]] == ["none", "none"]
    assert [material["roughness"]["kind"] for material in rough["materials"]] == ["none", "equation_8"]


def povray_text(scene: Scene) -> str:
    world = World.of_scene(scene)
    plan = analyse(world)
    return "\n".join(run.sdl for run in lower_povray(world, plan, settings_for(world, plan, "draft")).runs)


def test_povray_gets_photons_only_for_a_caustic() -> None:
    assert "photons" not in povray_text(make(FLOOR))
    assert "photons" in povray_text(ball_over_floor())
