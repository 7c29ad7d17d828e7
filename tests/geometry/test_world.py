"""A world is made once: what is asked of it is found out once, and other worlds are made from it without harm."""

from __future__ import annotations

from pathlib import Path

import pytest

import vitrail.geometry.mesh_file as mesh_file
from vitrail.base.changed import changed
from vitrail.geometry import world as world_module
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.world import World
from vitrail.scene.load import load_text

HEAD = """
vitrail: 1
camera: {position: [0, 5, 0], look_at: [0, 0, 0], up: [0, 0, -1], fov_deg: 40}
image: {width: 20, height: 10}
lights: [{name: lamp, point: {position: [0, 9, 0], intensity: 1}}]
materials:
  white: {diffuse: 0.5}
  glass: {transmission: 1, ior: 1.5}
  water: {transmission: 1, ior: 1.33}
"""
TABLE = "  - {name: table, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: white}\n"
TETRAHEDRON = "v 0 1 0\nv 1 2 0\nv 0 2 1\nv -1 1.5 -1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n"


def world_of(objects: str, folder: Path = Path()) -> World:
    return World.of(load_text(HEAD + "objects:\n" + objects, folder / "scene.yaml"))


def slab(name: str, low: float, high: float, more: str = "material: glass") -> str:
    return f"  - {{name: {name}, box: {{min: [-1, {low}, -1], max: [1, {high}, 1]}}, {more}}}\n"


def test_glass_that_stands_on_something_is_in_contact_with_it_and_glass_in_the_air_is_not() -> None:
    world = world_of(TABLE + slab("low", 0, 0.5) + slab("high", 0.5, 1) + slab("apart", 1.001, 2))
    # Of two glasses the earlier one gives way; the table is no glass, so it never comes first.
    assert world.contacts == ((1, 0), (1, 2))


def test_of_two_glasses_in_contact_the_one_of_lower_priority_gives_way() -> None:
    world = world_of(slab("low", 0, 0.5, "material: glass, priority: 2") + slab("high", 0.5, 1))
    assert world.contacts == ((1, 0),)


def test_a_ball_that_touches_in_a_point_is_in_no_contact() -> None:
    assert (
        world_of(TABLE + "  - {name: ball, sphere: {center: [0, 1, 0], radius: 1}, material: glass}\n").contacts == ()
    )


def test_a_box_that_stands_on_an_edge_is_in_no_contact() -> None:
    box = "box: {min: [-1, -1, -1], max: [1, 1, 1]}, rotate_deg: [0, 0, 45], translate: [0, 1.4142135623730951, 0]"
    assert world_of(TABLE + f"  - {{name: box, {box}, material: glass}}\n").contacts == ()


def test_the_glass_of_the_highest_priority_rules_around_points() -> None:
    inner = "  - {name: inner, sphere: {center: [0, 1, 0], radius: 0.5}, material: water, priority: 1}\n"
    world = world_of(slab("outer", 0, 2) + inner)
    assert world.medium_around([(0, 1, 0)]) == 1
    assert world.medium_around([(0, 1, 0)], but=1) == 0
    assert world.medium_around([(0, 1, 0), (0.9, 1, 0.9)]) == 0
    assert world.medium_around([(0, 1, 0), (0, 3, 0)]) is None
    assert world.displaces(1, 0) and not world.displaces(0, 1)


def test_an_overlap_is_searched_for_once(monkeypatch: pytest.MonkeyPatch) -> None:
    world, asked = world_of(slab("one", 0, 1) + slab("two", 0.5, 2)), []
    real = world_module.overlap
    monkeypatch.setattr(world_module, "overlap", lambda a, b: asked.append((a, b)) or real(a, b))
    again = world.with_scene(changed(world.scene, title="another"))
    assert world.overlap(0, 1).depth_m == again.overlap(0, 1).depth_m == pytest.approx(0.5, abs=1e-8)
    assert len(asked) == 1


def test_a_changed_scene_keeps_the_solids_of_objects_that_stay() -> None:
    world = world_of(TABLE + slab("one", 0, 1))
    table, one = world.scene.objects
    other = world.with_scene(changed(world.scene, objects=(changed(one, translate=(0.0, 1.0, 0.0)), table)))
    assert other.solid(table) is world.solids[0] and other.loaded is world.loaded
    assert other.bounds(one).low == (-1, 1, -1) and world.bounds(one).low == (-1, 0, -1)


def test_a_grown_mesh_is_another_solid_read_from_the_same_file_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "body.obj").write_text(TETRAHEDRON)
    read, real = [], mesh_file.read_bytes
    monkeypatch.setattr(mesh_file, "read_bytes", lambda *given: read.append(given) or real(*given))
    world = world_of("  - {name: body, mesh: {file: body.obj}, material: glass}\n", tmp_path)
    solid = world.solids[0]
    assert isinstance(solid, PlacedMesh) and not read
    larger = solid.grown(0.02).grown(-0.01)
    point = (0.0, 1.4, -0.1)
    assert solid.contains(point) and larger.distance(point) == pytest.approx(solid.distance(point) + 0.01, rel=1e-9)
    assert len(read) == 1 and world.with_solids({0: larger}).scene == world.scene
    assert larger.vertex_bounds == solid.vertex_bounds


def test_a_mesh_of_a_scene_without_a_folder_is_not_read_and_holds_nothing() -> None:
    scene = world_of("  - {name: body, mesh: {file: body.obj}, material: glass}\n").scene
    (solid,) = World.of_scene(scene).solids
    assert not solid.contains((0, 1.4, -0.1)) and solid.distances([(0, 0, 0)]) == [float("inf")]


def test_the_extent_leaves_out_what_is_infinite() -> None:
    assert world_of(TABLE + slab("one", 0, 1)).extent.low == (-1, 0, -1)
    # The lamp alone is a point, so the camera and what it looks at count too.
    assert world_of(TABLE).extent.high == (0, 9, 0) and world_of(TABLE).extent.low == (0, 0, 0)
