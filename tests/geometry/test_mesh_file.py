"""Meshes as their files say them: every legal variant of one solid is read alike, the rest is refused by name."""

from __future__ import annotations

import io
import os
import re
from pathlib import Path

import numpy as np
import pytest
from plyfile import PlyData, PlyElement

from vitrail.geometry.mesh_file import MeshFileError, ReadMesh, Triangles, placed, read_mesh
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
    return placed(read_mesh(tmp_path / name), Mesh(file=name, smooth=False), Frame())


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
    [
        OBJ_CUBE,
        "\N{ZERO WIDTH NO-BREAK SPACE}" + OBJ_CUBE,
        OBJ_CUBE + "f 1 2\n",
        "# a\ng b\nvt 0 0\n" + OBJ_CUBE,
        OBJ_CUBE.replace("f 1 3 4 2", "f 1 3 \\\n 4 2"),
        OBJ_CUBE.replace("f 1 3 4 2", "f 1 3 \\\n 4 2").replace("\n", "\r\n"),
        OBJ_CUBE.replace("\n", "\r"),
        OBJ_CUBE.replace("f 1 3 4 2", "f -8 -6 -5 -7"),
    ],
    ids=["plain", "byte order mark", "loose edge", "groups", "continued", "windows", "old mac", "from the end"],
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
        ("a.obj", OBJ_CUBE + "vn 0 0 nan\n" * 8, "line 15: `vn` is not finite"),
        ("a.obj", OBJ_CUBE + "f 1 2 1e999\n", "line 15: there is no vertex 1e999"),
        ("a.obj", OBJ_CUBE + "f 1//1 2//1 3//1\n", "a face names a normal that is not among its 0"),
        ("a.obj", OBJ_CUBE + "f 1 2 \\", "line 15: the file ends in the middle of a line"),
        ("a.obj", OBJ_CUBE.replace("v -1.0", "v -1_0"), "line 1: `-1_0` is no number"),
        ("a.obj", OBJ_CUBE.replace("v -1.0", "v -1e300"), "its vertex 0 is farther than 1e+09 m"),
        ("a.obj", OBJ_CUBE + "\0", "it is no text"),
        ("a.obj", "# nothing\n", "it has no faces"),
        ("a.ply", ASCII_CUBE.replace("end_header", "end"), "has no line `end_header`"),
        ("a.ply", ASCII_CUBE.replace("vertex 8", "vertex 99999999999"), "rows of `vertex` do not fit into the"),
        ("a.ply", ASCII_CUBE.replace("end_header", "element none 999\nend_header"), "rows of `none` do not fit"),
    ],
)
def test_what_is_no_mesh_is_refused_by_name(tmp_path: Path, name: str, content: str, words: str) -> None:
    with pytest.raises(MeshFileError) as caught:
        read(tmp_path, content.encode(), name)
    assert words in str(caught.value)


def cut(polygon: list[int], vertices: np.ndarray) -> list[tuple[int, ...]]:
    found = triangles_of(np.array(polygon), np.array([len(polygon)]), vertices)
    return [tuple(int(corner) for corner in each) for each in found]


ELL = np.array([[0, 0, 0], [3, 0, 0], [3, 1, 0], [1, 1, 0], [1, 3, 0], [0, 3, 0]], float)


@pytest.mark.parametrize("start", range(6))
@pytest.mark.parametrize("turned", [False, True])
def test_a_concave_polygon_is_cut_into_its_own_area(start: int, turned: bool) -> None:
    """An L of area 5: a fan from a corner whose view is blocked covers part of the notch."""
    outline = [(start + k) % 6 for k in range(6)]
    found = cut(outline[::-1] if turned else outline, ELL)
    areas = [np.cross(ELL[b] - ELL[a], ELL[c] - ELL[a])[2] / 2 for a, b, c in found]
    assert len(found) == 4 and sum(areas) == pytest.approx(-5 if turned else 5, abs=1e-12)
    assert all((area < 0) == turned for area in areas)
    middles = np.array([ELL[list(each)].mean(axis=0) for each in found])
    assert not ((middles[:, 0] > 1) & (middles[:, 1] > 1)).any()


def test_a_convex_polygon_stays_a_fan() -> None:
    assert cut([3, 2, 6, 7], CORNERS) == [(3, 2, 6), (3, 6, 7)]


def test_a_polygon_that_crosses_itself_is_refused() -> None:
    bow = np.array([[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0]], float)
    with pytest.raises(NotCuttable):
        cut([0, 1, 2, 3], bow)


def test_a_binary_file_that_ends_inside_its_last_row_is_refused(tmp_path: Path) -> None:
    """As long as the count of a list says, and not a byte further: another reader ran past the end here."""
    whole = binary("<", "f8", SIDES)
    for missing in (1, 4, 15, 17, len(whole) // 2):
        with pytest.raises(MeshFileError, match="early end-of-file|do not fit"):
            read(tmp_path, whole[:-missing])


def test_normals_of_an_obj_belong_to_the_corners_that_name_them(tmp_path: Path) -> None:
    """Six normals for eight vertices: each corner of the cube becomes three vertices, and every face is flat."""
    ways = [np.cross(CORNERS[b] - CORNERS[a], CORNERS[c] - CORNERS[b]) / 4 for a, b, c, _ in SIDES]
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS) + "".join(f"vn {x} {y} {z}\n" for x, y, z in ways)
    text += "".join("f " + " ".join(f"{each + 1}//{k + 1}" for each in side) + "\n" for k, side in enumerate(SIDES))
    (tmp_path / "cube.obj").write_text(text)
    mesh = placed(read_mesh(tmp_path / "cube.obj"), Mesh(file="cube.obj"), Frame())
    assert len(mesh.vertices) == 24 and mesh.normals is not None and volume(mesh) == CUBE
    facing = np.cross(mesh.corners[:, 1] - mesh.corners[:, 0], mesh.corners[:, 2] - mesh.corners[:, 1]) / 4
    assert np.array_equal(mesh.normals[mesh.faces], np.repeat(facing[:, None], 3, axis=1))


def test_a_comb_of_many_teeth_is_refused_within_seconds(tmp_path: Path) -> None:
    teeth = 4000
    corners = [(k, 0 if k % 2 else 1) for k in range(2 * teeth)]
    text = "v 0 -1 0\n" + "".join(f"v {x} {y} 0\n" for x, y in corners) + f"v {2 * teeth} -1 0\n"
    text += "f " + " ".join(str(each + 1) for each in range(2 * teeth + 1, -1, -1))
    with pytest.raises(MeshFileError, match="too many corners"):
        read(tmp_path, text.encode(), "comb.obj")


def test_only_regular_files_of_a_bounded_size_are_read(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.ply")
    (tmp_path / "folder.ply").mkdir()
    (tmp_path / "loop.ply").symlink_to("loop.ply")
    (tmp_path / "zero.ply").symlink_to("/dev/zero")
    with (tmp_path / "sparse.ply").open("wb") as file:
        file.truncate(200 * 10**9)
    says = {"pipe": "is no regular file", "folder": "is a folder", "loop": "cannot be read", "zero": "no regular file"}
    for name, words in {**says, "sparse": "has 2e+11 bytes", "nowhere": "cannot be read"}.items():
        with pytest.raises(MeshFileError, match=re.escape(words)):
            read_mesh(tmp_path / f"{name}.ply")


def test_a_file_is_read_again_when_it_has_changed(tmp_path: Path) -> None:
    first = read_mesh_of(tmp_path, OBJ_CUBE)
    assert read_mesh(tmp_path / "mesh.obj") is first
    assert len(read_mesh_of(tmp_path, OBJ_CUBE + "f 1 2 3\n").triangles) == 13


def read_mesh_of(tmp_path: Path, text: str) -> ReadMesh:
    (tmp_path / "mesh.obj").write_text(text)
    return read_mesh(tmp_path / "mesh.obj")
