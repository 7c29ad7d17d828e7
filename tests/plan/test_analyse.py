"""Every phenomenon, required where the scene shows it and spared where it does not, with its number."""

from __future__ import annotations

import pytest

from tests.plan.small_scenes import BALL, FLOOR, ball_over_floor, make
from vitrail.base.phenomenon import Phenomenon as P
from vitrail.geometry.world import World
from vitrail.plan.analyse import analyse, everything
from vitrail.plan.plan import Plan
from vitrail.scene.model import Scene

AWAY = "{position: [0, 8, 0], look_at: [0, 16, 0], up: [0, 0, -1], fov_deg: 40}"


def required(scene: Scene) -> set[P]:
    plan = analyse(World.of_scene(scene))
    return {phenomenon for phenomenon in P if plan.requires(phenomenon)}


def evidence(plan: Plan, phenomenon: P) -> str:
    return "\n".join(plan.entries[phenomenon].evidence)


def test_every_phenomenon_has_an_entry_with_evidence_and_cost() -> None:
    for scene in (ball_over_floor("flint"), make(FLOOR)):
        plan = analyse(World.of_scene(scene))
        assert list(plan.entries) == list(P)
        assert all(entry.evidence and all(entry.evidence) and entry.cost for entry in plan.entries.values())


def test_a_bare_floor_needs_diffusion_alone() -> None:
    assert required(make(FLOOR)) == {P.DIFFUSION}


def test_a_clear_ball_needs_no_reflection_and_no_bands() -> None:
    assert required(ball_over_floor("clear")) == {P.DIFFUSION, P.REFRACTION, P.CAUSTIC, P.SHADOW}


@pytest.mark.parametrize(
    ("material", "phenomenon", "words"),
    [
        ("mirror", P.REFLECTION, "mirrors 0.9"),
        ("window", P.REFLECTION, "mirrors 0.04 at normal incidence"),
        ("window", P.TOTAL_INTERNAL_REFLECTION, "beyond 41.8 deg"),
        ("bubble", P.TOTAL_INTERNAL_REFLECTION, "outside beyond 53.1 deg"),
        ("red", P.COLOURED_TRANSMISSION, "[0.81, 0.09, 0.01] through two"),
        ("smoky", P.ABSORPTION, "keeps [0.707, 0.5, 0.354] over its longest way, 3.46 m"),
        ("smoky", P.COLOURED_TRANSMISSION, "absorbs [0.1, 0.2, 0.3] per m"),
        ("flint", P.DISPERSION, "n 1.6 to 1.696"),
        ("bk7", P.DISPERSION, "n 1.5143 to 1.5267"),
        ("frosted", P.ROUGHNESS, "lambda 0.3) blurs by 3.75 deg"),
        ("ggx", P.ROUGHNESS, "alpha 0.1) blurs by 5.71 deg"),
        ("clear", P.CAUSTIC, "`sun` -> `ball` (at most 28.3 W) -> `floor` -> camera"),
        ("clear", P.SHADOW, "`ball` may shadow `floor` from `sun`"),
    ],
)
def test_what_is_needed_says_why(material: str, phenomenon: P, words: str) -> None:
    plan = analyse(World.of_scene(ball_over_floor(material)))
    assert plan.requires(phenomenon)
    assert words in evidence(plan, phenomenon)


@pytest.mark.parametrize(
    ("material", "phenomenon"),
    [
        ("clear", P.REFLECTION),
        ("clear", P.TOTAL_INTERNAL_REFLECTION),
        ("clear", P.COLOURED_TRANSMISSION),
        ("clear", P.ABSORPTION),
        ("clear", P.ROUGHNESS),
        ("clear", P.DISPERSION),
        ("mirror", P.REFRACTION),
        ("air", P.TOTAL_INTERNAL_REFLECTION),
        ("black", P.CAUSTIC),
    ],
)
def test_what_is_not_needed_says_why_not(material: str, phenomenon: P) -> None:
    plan = analyse(World.of_scene(ball_over_floor(material)))
    assert not plan.requires(phenomenon)
    assert plan.entries[phenomenon].cost == "none"


@pytest.mark.parametrize(
    ("material", "phenomenon", "number"),
    [
        ("faint_mirror", P.REFLECTION, "1e-07"),
        ("barely_smoky", P.ABSORPTION, "3.5e-09"),
        ("barely_flint", P.DISPERSION, " px, below the stated 0.01 px"),
        ("barely_frosted", P.ROUGHNESS, " px, below the stated 0.01 px"),
    ],
)
def test_what_is_below_the_stated_error_is_left_out_with_its_number(material: str, phenomenon: P, number: str) -> None:
    plan = analyse(World.of_scene(ball_over_floor(material)))
    assert not plan.requires(phenomenon)
    assert any("`ball`" in warning and number in warning for warning in plan.warnings)


def test_a_camera_that_looks_away_needs_nothing() -> None:
    assert required(ball_over_floor("flint", camera=AWAY)) == set()


def test_a_camera_that_sees_only_the_ball_sees_the_caustic_through_it() -> None:
    up = "{position: [0, 0.5, 0], look_at: [0, 2, 0], up: [0, 0, -1], fov_deg: 40}"
    assert P.CAUSTIC in required(ball_over_floor("clear", camera=up))


def test_without_light_there_is_no_caustic_and_no_shadow() -> None:
    assert {P.CAUSTIC, P.SHADOW}.isdisjoint(required(ball_over_floor("clear", lights=())))


def test_dispersion_that_only_the_camera_would_see_follows_the_paper_switch() -> None:
    panel = "{name: panel, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: black}"
    assert P.DISPERSION in required(make(panel, BALL % "flint"))
    assert P.DISPERSION not in required(make(panel, BALL % "flint", paper="{disperse_camera: false}"))


def test_indirect_light_needs_two_surfaces_and_a_wish() -> None:
    wall = "{name: wall, plane: {point: [0, 0, -5], normal: [0, 0, 1]}, material: white}"
    assert P.INDIRECT_LIGHT not in required(make(FLOOR, wall))
    assert P.INDIRECT_LIGHT not in required(make(FLOOR, transport="{indirect: photons}"))
    plan = analyse(World.of_scene(make(FLOOR, wall, transport="{indirect: photons}")))
    assert plan.requires(P.INDIRECT_LIGHT)
    assert "up to 4 times the direct light" in evidence(plan, P.INDIRECT_LIGHT)


def test_an_area_light_has_the_width_of_its_penumbra() -> None:
    """A lamp of radius 1, 4 m above a ball that is 2 m above the floor; the sphere around its bounds has radius sqrt 2:
    2 atan(sqrt 2 / 4) * 2 m = 1.36 m, in pixels of 2 * 8 m * tan(20 deg) / 100 = 5.8 cm."""
    lamp = "{name: lamp, area: {disc: {center: [0, 6, 0], normal: [0, -1, 0], radius: 1}, radiance: 5}}"
    plan = analyse(World.of_scene(ball_over_floor("black", lights=(lamp,))))
    assert "with an edge about 23 px wide" in evidence(plan, P.SHADOW)


def test_an_observation_in_vain_is_a_warning() -> None:
    spot = "{name: spot, phenomenon: caustic, patch: {center: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1]}}"
    assert any(
        "`spot` observes caustic" in warning
        for warning in analyse(World.of_scene(make(FLOOR, observe=(spot,)))).warnings
    )


def test_everything_is_on_as_far_as_the_materials_go() -> None:
    plan = everything(World.of_scene(ball_over_floor("clear", camera=AWAY)))
    assert {p for p in P if plan.requires(p)} == {
        P.DIFFUSION,
        P.REFLECTION,
        P.REFRACTION,
        P.TOTAL_INTERNAL_REFLECTION,
        P.COLOURED_TRANSMISSION,
        P.CAUSTIC,
        P.SHADOW,
    }
    assert (plan.chain.reflections, plan.chain.transmissions) == (8, 64)


def test_everything_needs_at_least_what_the_plan_needs() -> None:
    for material in ("mirror", "window", "flint", "frosted", "smoky", "air"):
        scene = ball_over_floor(material, transport="{indirect: photons}")
        most = everything(World.of_scene(scene))
        assert all(most.requires(phenomenon) for phenomenon in required(scene))


ROOM = "{name: room, sphere: {center: [0, 0, 0], radius: 5}, material: %s}"
INSIDE = "{position: [0, 0, 3], look_at: [0, 0, 0], fov_deg: 60}"
BULB = "{name: bulb, point: {position: [0, 1, 0], intensity: 1}}"


def test_a_room_seen_from_inside_lights_and_shadows_itself() -> None:
    scene = make(ROOM % "white", camera=INSIDE, lights=(BULB,), transport="{indirect: photons}")
    assert {P.INDIRECT_LIGHT, P.SHADOW} <= required(scene)


def test_the_same_ball_seen_from_outside_does_not() -> None:
    scene = make(ROOM % "white", lights=(BULB,), transport="{indirect: photons}")
    assert {P.INDIRECT_LIGHT, P.SHADOW}.isdisjoint(required(scene))


def test_the_same_ball_of_milky_glass_lights_itself_inside_where_all_can_see_it() -> None:
    scene = make(ROOM % "milky", lights=(BULB,), transport="{indirect: photons}")
    assert P.INDIRECT_LIGHT in required(scene)


def test_a_mirrored_room_has_caustics_and_no_end() -> None:
    scene = make(ROOM % "white", camera=INSIDE, lights=(BULB,))
    shiny = scene.materials["white"].model_copy(update={"reflection": (0.1, 0.1, 0.1)})
    room = scene.model_copy(update={"materials": {**scene.materials, "white": shiny}})
    assert P.CAUSTIC in required(room)
    assert not analyse(World.of_scene(room)).chain.proven
