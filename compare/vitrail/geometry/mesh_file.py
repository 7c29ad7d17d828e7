"""Triangles from a PLY or OBJ file: read once, here, for every engine; and placed in the world.

Vertex normals are those of the file, or for a smooth mesh without any the mean of the neighbouring faces, weighted by
their angle at the vertex, as in our tracer. Faces are no neighbours there that meet in a sharp edge.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from vitrail.base.input_file import InputFileError, look_at, read_bytes
from vitrail.geometry.creases import split_at_creases
from vitrail.geometry.frame import Frame
from vitrail.geometry.obj_file import read_obj
from vitrail.geometry.ply_file import read_ply
from vitrail.geometry.polygon_cut import triangles_of
from vitrail.scene.model import Mesh

MOST_BYTES = 2**29
"""Size of the largest file that is read: some 10 million triangles, more than either engine holds."""

LARGEST_M = 1e9
"""Largest coordinate, as everywhere in a scene."""

KEPT = 16
"""Files that stay in memory, for scenes that name one several times and for every step that asks."""


class MeshFileError(Exception):
    """The file cannot be read as a mesh; the message says why."""


@dataclass(frozen=True)
class ReadMesh:
    """What a file holds, in its own axes: vertices (n, 3) in metres, triangles (m, 3), and normals (n, 3) or None."""

    vertices: np.ndarray
    triangles: np.ndarray
    normals: np.ndarray | None


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


def read_mesh(path: Path, *, is_smooth: bool = False) -> ReadMesh:
    """Read a mesh; a file that has not changed is read once. Raises MeshFileError.

    One that ``is_smooth`` and has no normals has vertices of their own for each side of a sharp edge.
    """
    try:
        found = look_at(path)
    except InputFileError as error:
        raise MeshFileError(f"it {error}") from None
    state = (found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns)
    return _smooth(path, state) if is_smooth else _read(path, state)


def placed(mesh: ReadMesh, shape: Mesh, frame: Frame) -> Triangles:
    """A mesh where its frame puts it."""
    rotation = np.array(frame.rotation)
    vertices = mesh.vertices @ rotation.T + np.array(frame.origin)
    if not shape.smooth:
        return Triangles(vertices, mesh.triangles, None)
    if mesh.normals is not None:
        return Triangles(vertices, mesh.triangles, mesh.normals @ rotation.T)
    return Triangles(vertices, mesh.triangles, _angle_weighted(vertices, mesh.triangles))


@lru_cache(maxsize=KEPT)
def _smooth(path: Path, state: tuple[int, ...]) -> ReadMesh:
    read = _read(path, state)
    return read if read.normals is not None else ReadMesh(*split_at_creases(read.vertices, read.triangles), None)


@lru_cache(maxsize=KEPT)
def _read(path: Path, _state: tuple[int, ...]) -> ReadMesh:
    try:
        raw = read_bytes(path, MOST_BYTES)
        found = read_ply(path, raw) if raw.startswith(b"ply") else read_obj(raw)
        _refuse_beyond(found.vertices, "vertex", LARGEST_M)
        if found.normals is not None:
            _refuse_beyond(found.normals, "normal", np.inf)
        triangles = triangles_of(found.corners, found.counts, found.vertices)
    except InputFileError as error:
        raise MeshFileError(f"it {error}") from None
    except (ValueError, OverflowError) as error:
        raise MeshFileError(str(error)) from None
    if len(triangles) == 0:
        raise MeshFileError("it has no faces")
    if not _has_area(found.vertices[triangles]):
        raise MeshFileError("none of its triangles has an area")
    return ReadMesh(found.vertices, triangles, found.normals)


def _refuse_beyond(values: np.ndarray, what: str, largest: float) -> None:
    if not (finite := np.isfinite(values).all(axis=1)).all():
        raise ValueError(f"its {what} {int(np.argmin(finite))} is not finite")
    if not (near := (np.abs(values) <= largest).all(axis=1)).all():
        raise ValueError(f"its {what} {int(np.argmin(near))} is farther than {largest:g} m")


def _has_area(corners: np.ndarray) -> bool:
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return bool((area * area).sum(axis=1).any())


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
