"""A chain is bounded where geometry bounds it, and the scene's own limit elsewhere."""

from __future__ import annotations

import pytest

from tests.plan.small_scenes import BALL, FLOOR, ball_over_floor, make
from vitrail.geometry.world import World
from vitrail.plan.chains import longest_chain
from vitrail.scene.model import Scene

SECOND = "{name: second, sphere: {center: [5, 2, 0], radius: 1}, material: %s}"
PANE = "{name: pane, box: {min: [-1, 1, -1], max: [1, 1.1, 1]}, material: %s}"
INSIDE = "{position: [0, 2.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], fov_deg: 40}"
THROUGH = "{kind: orthographic, position: [0, 2, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 4}"
LAMP_INSIDE = "{name: lamp, point: {position: [0.5, 2, 0], intensity: 1}}"


@pytest.mark.parametrize(
    ("scene", "expected"),
    [
        (make(FLOOR), (0, 0)),
        (ball_over_floor("mirror"), (1, 0)),
        (ball_over_floor("clear"), (0, 2)),
        (make(FLOOR, PANE % "air", BALL % "air"), (0, 4)),
    ],
)
def test_proven_chains(scene: Scene, expected: tuple[int, int]) -> None:
    chain = longest_chain(World.of_scene(scene))
    assert chain.proven
    assert (chain.reflections, chain.transmissions) == expected


@pytest.mark.parametrize(
    "scene",
    [
        make(FLOOR, BALL % "mirror", SECOND % "clear"),
        make(FLOOR, BALL % "window", SECOND % "clear"),
        make(FLOOR, PANE % "window"),
        ball_over_floor("window", lights=(LAMP_INSIDE,)),
        ball_over_floor("clear", paper="{count_transmission: true}"),
    ],
)
def test_no_proof_means_the_limits_of_the_scene(scene: Scene) -> None:
    chain = longest_chain(World.of_scene(scene))
    assert not chain.proven
    assert (chain.reflections, chain.transmissions) == (8, 64)


@pytest.mark.parametrize(
    "scene",
    [
        make(FLOOR, BALL % "clear", SECOND % "clear"),
        make(FLOOR, PANE % "clear"),
        ball_over_floor("frosted"),
        ball_over_floor("clear", camera=INSIDE),
        ball_over_floor("clear", lights=(LAMP_INSIDE,)),
        ball_over_floor("clear", paper="{refraction: literal}"),
        ball_over_floor("clear", paper="{tir: drop}", camera=INSIDE),
        ball_over_floor("clear", transport="{indirect: photons}"),
        ball_over_floor("clear", camera=THROUGH),
    ],
)
def test_what_reflects_only_totally_makes_no_reflection(scene: Scene) -> None:
    chain = longest_chain(World.of_scene(scene))
    assert not chain.proven
    assert (chain.reflections, chain.transmissions) == (0, 64)


@pytest.mark.parametrize(("material", "mirrored"), [("window", 8), ("bubble", 0), ("flint", 0)])
def test_light_enters_and_leaves_a_ball_once_however_often_it_is_mirrored_inside(material: str, mirrored: int) -> None:
    chain = longest_chain(World.of_scene(ball_over_floor(material)))
    assert not chain.proven
    assert (chain.reflections, chain.transmissions) == (mirrored, 2)


@pytest.mark.parametrize(
    "scene", [make(FLOOR, BALL % "mirror", SECOND % "mirror"), ball_over_floor("mirror", camera=INSIDE)]
)
def test_mirrors_alone_are_never_crossed(scene: Scene) -> None:
    chain = longest_chain(World.of_scene(scene))
    assert (chain.reflections, chain.transmissions, chain.proven) == (8, 0, False)


def test_a_chain_never_exceeds_what_the_scene_allows() -> None:
    chain = longest_chain(World.of_scene(ball_over_floor("clear", transport="{max_transmissions: 1}")))
    assert (chain.reflections, chain.transmissions) == (0, 1)
