"""Smooth meshes without normals: round where their faces turn by little, sharp where they turn by much."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from vitrail.geometry.creases import split_at_creases
from vitrail.geometry.frame import Frame
from vitrail.geometry.mesh_file import placed, read_mesh
from vitrail.scene.model import Mesh

HERE = Frame((0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))


def drum(sides: int) -> tuple[np.ndarray, np.ndarray]:
    """A closed prism of many sides about the z axis, of radius and half height 1, outward triangles."""
    turn = 2 * math.pi * np.arange(sides) / sides
    rim = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    rings = [np.column_stack([rim, np.full(sides, z)]) for z in (-1.0, 1.0)]
    vertices = np.concatenate([*rings, [[0, 0, -1], [0, 0, 1]]])
    faces = []
    for k in range(sides):
        n = (k + 1) % sides
        faces += [(k, n, sides + n), (k, sides + n, sides + k)]
        faces += [(2 * sides, n, k), (2 * sides + 1, sides + k, sides + n)]
    return vertices, np.array(faces)


def normals_of(vertices: np.ndarray, triangles: np.ndarray, folder: Path) -> np.ndarray:
    """The unit normal of each corner, (m, 3, 3), of a file with these triangles as the engines get it."""
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    rows += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles.tolist()]
    (folder / "body.obj").write_text("\n".join(rows) + "\n")
    shape = Mesh(file="body.obj")
    made = placed(read_mesh(folder / "body.obj", is_smooth=True), shape, HERE)
    assert made.normals is not None
    assert made.corners == pytest.approx(vertices[triangles])
    found = made.normals[made.faces]
    return np.asarray(found / np.linalg.norm(found, axis=2, keepdims=True))


def test_a_drum_of_24_sides_is_round_about_and_flat_at_its_ends(tmp_path: Path) -> None:
    """Its sides turn by 15 degrees, its rims by 90: normals lead away from the axis, or along it."""
    vertices, triangles = drum(24)
    normals = normals_of(vertices, triangles, tmp_path)
    corners = vertices[triangles]
    is_end = np.ptp(corners[:, :, 2], axis=1) == 0
    ends = np.sign(corners[is_end][:, :, 2])
    assert normals[is_end][:, :, 2] == pytest.approx(ends)
    outwards = corners[~is_end] * [1, 1, 0]
    # The two triangles of a side weigh differently at its corners: a few degrees.
    assert np.einsum("mki,mki->mk", normals[~is_end], outwards).min() > math.cos(math.radians(5))
    assert normals[~is_end][:, :, 2] == pytest.approx(0, abs=1e-12)


def test_a_drum_of_eight_sides_is_sharp_everywhere(tmp_path: Path) -> None:
    """It turns by 45 degrees: every corner of a triangle has the triangle's own normal."""
    vertices, triangles = drum(8)
    corners = vertices[triangles]
    flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat /= np.linalg.norm(flat, axis=1, keepdims=True)
    assert normals_of(vertices, triangles, tmp_path) == pytest.approx(np.repeat(flat[:, None], 3, axis=1))


def test_a_mesh_without_sharp_edges_stays_as_it_is() -> None:
    """A fan bent by 30 degrees: the same arrays, not even copies."""
    vertices = np.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [-math.cos(math.pi / 6), 0, 0.5]])
    triangles = np.array([[0, 2, 1], [0, 1, 3]])
    same, kept = split_at_creases(vertices, triangles)
    assert same is vertices and kept is triangles
