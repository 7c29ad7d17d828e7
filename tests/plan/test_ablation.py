"""An ablated scene differs from its scene in what is meant to be off, and in nothing else."""

from __future__ import annotations

from typing import Any

import pytest

from tests.plan.small_scenes import FLOOR, ball_over_floor, make
from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.ablation import Ablation, ablations
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import load_text
from vitrail.scene.model import Scene
from vitrail.scene.print import print_scene

P = Phenomenon
COVER = "{name: cover, rectangle: {center: [-1, 0.5, 0], u: [1, 0, 0], v: [0, 0, -3]}, material: black}"
ON_FLOOR = "{name: spot, phenomenon: shadow, patch: {center: [0, 0, 0], u: [0.1, 0, 0], v: [0, 0, -0.1]}}"
AMBIENT = "{indirect: {ambient: 1}}"


def off(scene: Scene, name: str) -> Ablation:
    world = World.of_scene(scene)
    return next(each for each in ablations(world, analyse(world)) if each.name == name)


def names(scene: Scene) -> list[str]:
    world = World.of_scene(scene)
    return [each.name for each in ablations(world, analyse(world))]


def changed(old: Any, new: Any, place: str = "") -> dict[str, Any]:
    """The leaves in which two values of JSON differ, by their place, with the new value."""
    if isinstance(old, dict) and isinstance(new, dict):
        keys = sorted(set(old) | set(new))
        return {k: v for key in keys for k, v in changed(old.get(key), new.get(key), f"{place}.{key}").items()}
    return {} if old == new else {place.lstrip("."): new}


@pytest.mark.parametrize(
    ("name", "phenomenon", "difference"),
    [
        ("flint", "dispersion", {"flint.dispersion": None, "flint.ior": pytest.approx(1.6 + 1.5 * 0.032)}),
        ("bk7", "dispersion", {"bk7.glass": None, "bk7.ior": pytest.approx(1.5168, abs=1e-5)}),
        ("frosted", "roughness", {"frosted.roughness": 0.0}),
        ("ggx", "roughness", {"ggx.roughness": 0.0}),
        ("smoky", "absorption", {"smoky.absorption_per_m": None}),
        ("red", "coloured_transmission", {"red.transmission": (1.0, 1.0, 1.0)}),
        ("window", "reflection", {"window.fresnel": False}),
        ("mirror", "reflection", {"mirror.reflection": (1.0, 1.0, 1.0)}),
    ],
)
def test_only_the_material_s_own_part_is_off(name: str, phenomenon: str, difference: dict[str, Any]) -> None:
    scene = ball_over_floor(name)
    ablated = off(scene, phenomenon)
    own = changed(scene.materials[name].model_dump(), ablated.scene.materials[name].model_dump())
    assert {f"{name}.{key}": value for key, value in own.items()} == difference
    assert ablated.scene.model_copy(update={"materials": scene.materials}) == scene
    assert ablated.absent == {P(phenomenon)} and P(phenomenon) in ablated.touched


def test_straight_on_is_index_one_and_what_hangs_on_the_index() -> None:
    scene = ball_over_floor("window")
    ablated = off(scene, "refraction")
    glass = ablated.scene.materials["window"]
    assert (glass.ior, glass.fresnel, glass.transmission) == (1.0, False, (1.0, 1.0, 1.0))
    assert ablated.absent >= {P.REFRACTION, P.TOTAL_INTERNAL_REFLECTION}
    assert ablated.touched >= {P.CAUSTIC, P.REFLECTION}, "a caustic is not gathered, Fresnel mirrors nothing"
    assert P.REFLECTION not in off(ball_over_floor("clear"), "refraction").touched


def test_bodies_are_made_black_and_then_taken_away() -> None:
    scene = ball_over_floor("clear")
    black, bare = off(scene, "caustic"), off(scene, "specular bodies")
    assert black.scene.objects == scene.objects and black.darkens
    assert not black.scene.materials["clear"].is_specular and P.SHADOW not in black.touched
    assert [item.name for item in bare.scene.objects] == ["floor"] and P.SHADOW in bare.touched
    assert bare.scene.lights == scene.lights and bare.scene.camera == scene.camera


def test_what_carries_a_patch_stays_and_what_shadows_it_goes() -> None:
    scene = make(FLOOR, COVER, observe=(ON_FLOOR,))
    ablated = off(scene, "shadow")
    assert [item.name for item in ablated.scene.objects] == ["floor"]
    assert names(make(FLOOR, observe=(ON_FLOOR,))) == []
    on_cover = ON_FLOOR.replace("spot", "lid").replace("[0, 0, 0]", "[-1, 0.5, 0]", 1)
    assert names(make(FLOOR, COVER, observe=(ON_FLOOR, on_cover))) == [], "what carries a patch is not taken away"


def test_indirect_light_is_switched_off_in_the_transport_alone() -> None:
    scene = make(FLOOR, transport=AMBIENT)
    less = off(scene, "indirect_light").scene
    assert less.transport.indirect == "none"
    assert less.model_copy(update={"transport": scene.transport}) == scene


def test_what_a_plan_does_not_require_is_not_switched_off() -> None:
    assert names(ball_over_floor("clear")) == ["refraction", "caustic", "specular bodies"]
    assert names(make(FLOOR)) == []


@pytest.mark.parametrize("name", ["red", "flint", "bk7", "frosted", "ggx", "smoky", "mirror", "window", "clear"])
def test_every_ablated_scene_is_a_scene_and_both_engines_read_the_same(name: str) -> None:
    """It can be printed and read again with all checks, and lowered: no engine gets a form of its own."""
    scene = ball_over_floor(name)
    world = World.of_scene(scene)
    for ablated in ablations(world, analyse(world)):
        assert load_text(print_scene(ablated.scene)).scene == ablated.scene, ablated.name
        world = World.of_scene(ablated.scene)
        plan = analyse(world)
        lowered = lower_tracer(world, plan, settings_for(world, plan, "draft"))
        assert len(lowered["objects"]) == len(ablated.scene.objects)
        assert ablated.absent <= ablated.touched | {P.SHADOW}
