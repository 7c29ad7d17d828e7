"""Meshes as their files say them: every legal variant of one solid is read alike, the rest is refused by name."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from plyfile import PlyData, PlyElement

from vitrail.geometry.mesh_file import MeshFileError, Triangles, read_triangles
from vitrail.geometry.placement import Frame
from vitrail.geometry.polygon_cut import NotCuttable, triangles_of
from vitrail.scene.model import Mesh

CORNERS = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], float)
SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
CUBE = 8.0
"""Volume of the cube with these corners, m3."""

ASCII_CUBE = (
    """ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 6
property list uchar int vertex_indices
end_header
"""
    + "".join(f"{x} {y} {z}\n" for x, y, z in CORNERS)
    + "".join(f"4 {a} {b} {c} {d}\n" for a, b, c, d in SIDES)
)

OBJ_CUBE = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS) + "".join(
    "f " + " ".join(str(each + 1) for each in side) + "\n" for side in SIDES
)


def read(tmp_path: Path, content: bytes, name: str = "mesh.ply") -> Triangles:
    (tmp_path / name).write_bytes(content)
    return read_triangles(tmp_path / name, Mesh(file=name, smooth=False), Frame())


def volume(mesh: Triangles) -> float:
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    return float((np.cross(a, b) * c).sum() / 6)


def binary(order: str, number: str, corners: list[tuple[int, ...]]) -> bytes:
    vertices = np.array([tuple(each) for each in CORNERS], dtype=[(key, number) for key in "xyz"])
    faces = np.empty(len(corners), dtype=[("vertex_indices", object)])
    faces["vertex_indices"] = [np.array(each, "i4") for each in corners]
    out = io.BytesIO()
    elements = [PlyElement.describe(vertices, "vertex"), PlyElement.describe(faces, "face")]
    PlyData(elements, byte_order=order).write(out)
    return out.getvalue()


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("number", ["f4", "f8"])
@pytest.mark.parametrize("cut", [True, False], ids=["triangles", "quads"])
def test_binary_files_of_either_byte_order_are_the_same_cube(
    tmp_path: Path, order: str, number: str, cut: bool
) -> None:
    triangles = [each for a, b, c, d in SIDES for each in ((a, b, c), (a, c, d))]
    mesh = read(tmp_path, binary(order, number, triangles if cut else SIDES))
    assert len(mesh.faces) == 12 and volume(mesh) == CUBE


@pytest.mark.parametrize(
    "variant",
    [
        ASCII_CUBE,
        ASCII_CUBE.replace("\n", "\r\n"),
        ASCII_CUBE.replace("format ascii 1.0", "format ascii 1.0\ncomment a cube"),
        ASCII_CUBE.replace("vertex_indices", "vertex_index").replace("uchar int", "uint8 uint32"),
    ],
    ids=["plain", "windows", "comment", "other names"],
)
def test_ascii_files_are_the_same_cube(tmp_path: Path, variant: str) -> None:
    assert volume(read(tmp_path, variant.encode())) == CUBE


def test_a_vertex_in_ascii_keeps_every_digit(tmp_path: Path) -> None:
    """One third as a float would be off by 1e-8, a thousand times what the tracer resolves."""
    mesh = read(tmp_path, ASCII_CUBE.replace("1.0 1.0 1.0\n", "1.0 1.0 0.333333333333333315\n").encode())
    assert mesh.vertices[7, 2] == 1 / 3


@pytest.mark.parametrize(
    "variant",
    [OBJ_CUBE, "\N{ZERO WIDTH NO-BREAK SPACE}" + OBJ_CUBE, OBJ_CUBE + "f 1 2\n", "# a\ng b\nvt 0 0\n" + OBJ_CUBE],
    ids=["plain", "byte order mark", "loose edge", "groups"],
)
def test_obj_files_are_the_same_cube(tmp_path: Path, variant: str) -> None:
    assert volume(read(tmp_path, variant.encode(), "mesh.obj")) == CUBE


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.ply", ASCII_CUBE[:-20], "element 'face': row 4: early end-of-file"),
        ("a.ply", ASCII_CUBE.replace("4 0 2 3 1", "4 0 2 3 8"), "a face names a vertex that is not among its 8"),
        ("a.ply", ASCII_CUBE.replace("4 0 2 3 1", "4 0 2 3 inf"), "malformed input"),
        ("a.ply", ASCII_CUBE.replace("vertex_indices", "other"), "its faces have no list of corners"),
        ("a.ply", ASCII_CUBE.replace("property float z\n", ""), "expected end-of-line"),
        ("a.ply", ASCII_CUBE.replace("1.0 1.0 1.0\n", "1.0 1.0 nan\n"), "its vertex 6 is not finite"),
        ("a.ply", ASCII_CUBE.replace("element face", "elephant face"), "expected one of"),
        ("a.obj", OBJ_CUBE.replace("v -1.0 -1.0 -1.0", "v -1.0 -1.0"), "line 1: `v` needs three numbers"),
        ("a.obj", OBJ_CUBE + "f 1 2 9\n", "a face names a vertex that is not among its 8"),
        ("a.obj", OBJ_CUBE + "f 1 2 0\n", "line 15: there is no vertex 0"),
        ("a.obj", OBJ_CUBE + "f 1 2 99999999999999999999\n", "line 15: there is no vertex"),
        ("a.obj", OBJ_CUBE + "vn 0 0 nan\n" * 8, "its normal 0 is not finite"),
        ("a.obj", "# nothing\n", "it has no faces"),
    ],
)
def test_what_is_no_mesh_is_refused_by_name(tmp_path: Path, name: str, content: str, words: str) -> None:
    with pytest.raises(MeshFileError) as caught:
        read(tmp_path, content.encode(), name)
    assert words in str(caught.value)


ELL = np.array([[0, 0, 0], [3, 0, 0], [3, 1, 0], [1, 1, 0], [1, 3, 0], [0, 3, 0]], float)


@pytest.mark.parametrize("start", range(6))
@pytest.mark.parametrize("turned", [False, True])
def test_a_concave_polygon_is_cut_into_its_own_area(start: int, turned: bool) -> None:
    """An L of area 5: a fan from a corner whose view is blocked covers part of the notch."""
    outline = [(start + k) % 6 for k in range(6)]
    found = triangles_of(outline[::-1] if turned else outline, ELL)
    areas = [np.cross(ELL[b] - ELL[a], ELL[c] - ELL[a])[2] / 2 for a, b, c in found]
    assert len(found) == 4 and sum(areas) == pytest.approx(-5 if turned else 5, abs=1e-12)
    assert all((area < 0) == turned for area in areas)
    middles = np.array([ELL[list(each)].mean(axis=0) for each in found])
    assert not ((middles[:, 0] > 1) & (middles[:, 1] > 1)).any()


def test_a_convex_polygon_stays_a_fan() -> None:
    assert triangles_of([3, 2, 6, 7], CORNERS) == [(3, 2, 6), (3, 6, 7)]


def test_a_polygon_that_crosses_itself_is_refused() -> None:
    bow = np.array([[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0]], float)
    with pytest.raises(NotCuttable):
        triangles_of([0, 1, 2, 3], bow)
