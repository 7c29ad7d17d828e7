"""The reduced scene has lost what its plan leaves out, and nothing else."""

from __future__ import annotations

import pytest

from tests.plan.small_scenes import ball_over_floor
from vitrail.geometry.world import World
from vitrail.plan.analyse import analyse, everything
from vitrail.plan.reduced import reduced
from vitrail.scene.model import Material

FAINT = {
    "barely_frosted": {"roughness": 0.0},
    "barely_flint": {"dispersion": None},
    "barely_smoky": {"absorption_per_m": None},
    "faint_mirror": {"reflection": (0.0, 0.0, 0.0)},
}


@pytest.mark.parametrize("name", FAINT)
def test_what_is_below_the_stated_error_is_taken_out(name: str) -> None:
    scene = ball_over_floor(name)
    assert reduced(scene, analyse(World.of_scene(scene))).materials[name] == scene.materials[name].model_copy(
        update=FAINT[name]
    )


def test_a_glass_that_need_not_disperse_keeps_the_index_of_its_d_line() -> None:
    away = "{position: [0, 8, 0], look_at: [0, 16, 0], up: [0, 0, -1], fov_deg: 40}"
    scene = ball_over_floor("bk7", camera=away)
    kept = reduced(scene, analyse(World.of_scene(scene))).materials["bk7"]
    assert (kept.glass, kept.ior) == (None, pytest.approx(1.51680, abs=5e-6))


@pytest.mark.parametrize("name", ["frosted", "ggx", "flint", "bk7", "smoky", "mirror", "window", "red"])
def test_what_shows_stays(name: str) -> None:
    scene = ball_over_floor(name)
    assert reduced(scene, analyse(World.of_scene(scene))).materials[name] == scene.materials[name]


@pytest.mark.parametrize("name", FAINT)
def test_everything_on_takes_nothing_out(name: str) -> None:
    scene = ball_over_floor(name)
    kept = reduced(scene, everything(World.of_scene(scene)))
    assert kept.materials[name] == scene.materials[name]
    assert kept.transport == scene.transport


def test_a_reduced_scene_is_still_a_scene() -> None:
    for name in FAINT:
        scene = ball_over_floor(name)
        for material in reduced(scene, analyse(World.of_scene(scene))).materials.values():
            assert Material.model_validate(material.model_dump(by_alias=True)) == material
