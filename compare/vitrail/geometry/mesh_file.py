"""Triangles from a PLY or OBJ file, in the world.

Vertex normals are those of the file, or for a smooth mesh without any the mean of the neighbouring faces, weighted by
their angle at the vertex, as in our tracer. Polygons are cut into fans.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vitrail.geometry.placement import Frame
from vitrail.scene.model import Mesh

_NUMBERS = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("double", "float64"), "f8"),
}


class MeshFileError(Exception):
    """The file cannot be read as a mesh; the message says why."""


@dataclass(frozen=True)
class Triangles:
    """World vertices (n, 3) in metres, faces (m, 3), and for a smooth mesh one normal a vertex."""

    vertices: np.ndarray
    faces: np.ndarray
    normals: np.ndarray | None

    @property
    def corners(self) -> np.ndarray:
        """The corners of every face, (m, 3, 3)."""
        return self.vertices[self.faces]


def read_triangles(path: Path, mesh: Mesh, frame: Frame) -> Triangles:
    """Read and place a mesh. Raises MeshFileError."""
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise MeshFileError(f"it cannot be read ({error.strerror})") from None
    try:
        vertices, normals, faces = _ply(raw) if raw.startswith(b"ply") else _obj(raw.decode("utf-8", "replace"))
    except (ValueError, IndexError, KeyError) as error:
        raise MeshFileError(f"it is not a mesh in PLY or OBJ ({error})") from None
    if len(faces) == 0 or not np.isfinite(vertices).all() or faces.max() >= len(vertices) or faces.min() < 0:
        raise MeshFileError("it has no faces, or faces without vertices")
    rotation = np.array(frame.rotation)
    placed = vertices @ rotation.T + np.array(frame.origin)
    if not mesh.smooth:
        return Triangles(placed, faces, None)
    normals = _angle_weighted(placed, faces) if normals is None else normals @ rotation.T
    return Triangles(placed, faces, normals)


def _angle_weighted(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Normals of the vertices as the mean of those of the faces, each with its angle at the vertex."""
    normals = np.zeros_like(vertices)
    corners = vertices[faces]
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(area, axis=1, keepdims=True)
    unit = np.divide(area, length, out=np.zeros_like(area), where=length > 0)
    for k in range(3):
        following = corners[:, (k + 1) % 3] - corners[:, k]
        previous = corners[:, (k + 2) % 3] - corners[:, k]
        angle = np.arctan2(length[:, 0], (following * previous).sum(axis=1))
        np.add.at(normals, faces[:, k], unit * angle[:, None])
    return normals


# --- OBJ ------------------------------------------------------------------------------------------------------------


def _obj(text: str) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
    """Vertices and faces; normals count where every vertex has one of the same number."""
    vertices, normals, faces = [], [], []
    for line in text.splitlines():
        words = line.split()
        match words[:1]:
            case ["v"]:
                vertices.append([float(word) for word in words[1:4]])
            case ["vn"]:
                normals.append([float(word) for word in words[1:4]])
            case ["f"]:
                found = [int(word.split("/")[0]) for word in words[1:]]
                corners = [each - 1 if each > 0 else len(vertices) + each for each in found]
                faces += [[corners[0], b, c] for b, c in zip(corners[1:-1], corners[2:], strict=True)]
            case _:
                continue
    kept = np.array(normals) if normals and len(normals) == len(vertices) else None
    return np.array(vertices, float), kept, np.array(faces, int)


# --- PLY ------------------------------------------------------------------------------------------------------------


def _ply(raw: bytes) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
    """ASCII or binary of either byte order; vertices with x, y, z (nx, ny, nz), faces with a list of indices."""
    end = raw.index(b"end_header")
    start = raw.index(b"\n", end) + 1
    order, elements = _ply_header(raw[:end].decode("ascii", "replace").splitlines())
    read = _AsciiRows(raw[start:]) if order == "" else _BinaryRows(raw[start:], order)
    vertices = normals = None
    faces: list[list[int]] = []
    for name, count, properties in elements:
        rows = [read.row(properties) for _ in range(count)]
        names = [each[-1] for each in properties]
        if name == "vertex":
            columns = {key: [row[i] for row in rows] for i, key in enumerate(names)}
            vertices = np.array([columns[key] for key in "xyz"], float).T
            if {"nx", "ny", "nz"} <= set(names):
                normals = np.array([columns[key] for key in ("nx", "ny", "nz")], float).T
        elif name == "face":
            at = next(i for i, key in enumerate(names) if key in ("vertex_indices", "vertex_index"))
            for corners in (row[at] for row in rows):
                assert isinstance(corners, list)
                first, *rest = (int(each) for each in corners)
                faces += [[first, b, c] for b, c in zip(rest, rest[1:], strict=False)]
    if vertices is None:
        raise ValueError("no vertices")
    return vertices, normals, np.array(faces, int)


Property = tuple[str, ...]
Cell = float | list[float]
Element = tuple[str, int, list[Property]]


def _ply_header(lines: list[str]) -> tuple[str, list[Element]]:
    """The byte order (empty for ASCII) and the elements with their properties."""
    order, elements = "", list[Element]()
    for words in (line.split() for line in lines):
        match words:
            case ["format", kind, _]:
                order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[kind]
            case ["element", name, count]:
                elements.append((name, int(count), []))
            case ["property", *kinds]:
                elements[-1][2].append(tuple(kinds))
            case _:
                continue
    return order, elements


class _AsciiRows:
    """Numbers as words, in order."""

    def __init__(self, raw: bytes) -> None:
        self._words = iter(raw.split())

    def row(self, properties: list[Property]) -> list[Cell]:
        found: list[Cell] = []
        for kind in properties:
            if kind[0] == "list":
                found.append([float(next(self._words)) for _ in range(int(next(self._words)))])
            else:
                found.append(float(next(self._words)))
        return found


class _BinaryRows:
    """Numbers as bytes, in order."""

    def __init__(self, raw: bytes, order: str) -> None:
        self._raw, self._order, self._at = raw, order, 0

    def row(self, properties: list[Property]) -> list[Cell]:
        found: list[Cell] = []
        for kind in properties:
            if kind[0] == "list":
                count = int(self._take(kind[1], 1)[0])
                found.append(self._take(kind[2], count).tolist())
            else:
                found.append(float(self._take(kind[0], 1)[0]))
        return found

    def _take(self, kind: str, count: int) -> np.ndarray:
        numbers = np.frombuffer(self._raw, self._order + _NUMBERS[kind], count, self._at)
        self._at += numbers.nbytes
        return numbers
