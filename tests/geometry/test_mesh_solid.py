"""What a mesh encloses, against a cube whose every answer is known."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest

from vitrail.geometry.frame import Frame
from vitrail.geometry.mesh_file import Triangles, placed, read_mesh
from vitrail.geometry.mesh_solid import HAIR, MeshSolid, fault_of_solid
from vitrail.scene.model import Mesh

FOLDER = Path(__file__).parents[1] / "malformed"
TURN = ((0.36, 0.48, -0.8), (-0.8, 0.6, 0.0), (0.48, 0.64, 0.6))


def cube(frame: Frame = Frame(), name: str = "cube.obj") -> MeshSolid:  # noqa: B008  (frozen)
    """Half edge 1 around the origin of a frame."""
    return MeshSolid(placed(read_mesh(FOLDER / name), Mesh(file=name, smooth=False), frame))


def points() -> np.ndarray:
    return np.random.default_rng(1).uniform(-2, 2, (500, 3))


@pytest.mark.parametrize("frame", [Frame(), Frame((0.5, -3.0, 7.0), TURN)])
def test_inside_and_distance_are_those_of_the_cube(frame: Frame) -> None:
    solid, local = cube(frame), points()
    world = np.array([frame.point((x, y, z)) for x, y, z in local.tolist()])
    beyond = np.abs(local) - 1
    outside = np.linalg.norm(np.maximum(beyond, 0), axis=1)
    expected = np.where(outside > 0, -outside, -beyond.max(axis=1))
    assert np.array_equal(solid.winding(world), (expected > 0).astype(int))
    np.testing.assert_allclose(solid.depth(world), expected, atol=1e-12)


def test_a_moved_cube_keeps_its_corners_sharp() -> None:
    moved = cube().moved(0.25).vertices
    assert sorted(map(tuple, np.round(moved, 12).tolist())) == sorted(product((-1.25, 1.25), repeat=3))


def test_the_thickness_is_the_edge() -> None:
    assert cube().thickness() == pytest.approx(2, rel=1e-12)


def test_inner_points_are_a_hair_inside() -> None:
    solid = cube()
    np.testing.assert_allclose(solid.depth(solid.inner_points()), HAIR * solid.size, rtol=1e-6)


def test_only_a_solid_has_no_fault() -> None:
    assert fault_of_solid(cube()) is None
    assert str(fault_of_solid(cube(name="open.obj"))).startswith("has a hole")
    assert str(fault_of_solid(cube(name="inside_out.obj"))).startswith("is inside out")
    assert "crosses itself" in str(fault_of_solid(cube(name="bow_tie.obj")))


def two_cubes(shift: tuple[float, float, float], size: float = 1.0, inside_out: bool = False) -> MeshSolid:
    """A second cube in the same mesh: of another size, moved, and inside out where it is a bubble."""
    one = cube().triangles
    faces = one.faces[:, ::-1] if inside_out else one.faces
    vertices = np.concatenate([one.vertices, one.vertices * size + np.array(shift)])
    return MeshSolid(Triangles(vertices, np.concatenate([one.faces, faces + len(one.vertices)]), None))


def test_parts_of_a_mesh_may_stand_apart_or_be_bubbles_and_nothing_else() -> None:
    assert fault_of_solid(two_cubes((3, 0, 0))) is None
    assert fault_of_solid(two_cubes((0, 0, 0), 0.5, inside_out=True)) is None
    for shift, size in (((0, 0, 0), 0.5), ((0, 0, 0), 1e-4), ((0.5, 0.25, 0.125), 1)):
        assert "has a part inside another" in str(fault_of_solid(two_cubes(shift, size)))
    assert "has two parts that touch along an edge at" in str(fault_of_solid(two_cubes((2, 0, 0))))
