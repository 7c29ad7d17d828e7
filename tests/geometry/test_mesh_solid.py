"""What a mesh encloses, against a cube whose every answer is known."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest

from vitrail.geometry.frame import Frame
from vitrail.geometry.mesh_file import placed, read_mesh
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
    assert fault_of_solid(cube(name="open.obj")) == "has a hole"
    assert fault_of_solid(cube(name="inside_out.obj")) == "is inside out"
    assert "crosses itself" in (fault_of_solid(cube(name="bow_tie.obj")) or "")
