"""Triangles from a PLY or OBJ file, in the world.

Vertex normals are those of the file, or for a smooth mesh without any the mean of the neighbouring faces, weighted by
their angle at the vertex, as in our tracer. Polygons are cut into triangles by ``polygon_cut``.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vitrail.geometry.frame import Frame
from vitrail.geometry.obj_file import read_obj
from vitrail.geometry.ply_file import read_ply
from vitrail.geometry.raw_mesh import RawMesh
from vitrail.scene.model import Mesh

MOST_BYTES = 2**31
"""Size of the largest file that is read: some 40 million triangles, more than either engine holds."""


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
    raw = _read_whole(path)
    try:
        found = read_ply(path, raw) if raw.startswith(b"ply") else read_obj(raw.decode("utf-8", "replace"))
        _refuse_infinite(found)
        faces = found.triangles()
    except (ValueError, OverflowError) as error:
        raise MeshFileError(str(error)) from None
    if len(faces) == 0:
        raise MeshFileError("it has no faces")
    vertices, normals = found.vertices, found.normals
    rotation = np.array(frame.rotation)
    placed = vertices @ rotation.T + np.array(frame.origin)
    if not mesh.smooth:
        return Triangles(placed, faces, None)
    normals = _angle_weighted(placed, faces) if normals is None else normals @ rotation.T
    return Triangles(placed, faces, normals)


def _refuse_infinite(mesh: RawMesh) -> None:
    for values, what in ((mesh.vertices, "vertex"), (mesh.normals, "normal")):
        if values is not None and not (finite := np.isfinite(values).all(axis=1)).all():
            raise ValueError(f"its {what} {int(np.argmin(finite))} is not finite")


def _read_whole(path: Path) -> bytes:
    try:
        if (size := path.stat().st_size) > MOST_BYTES:
            raise MeshFileError(f"it has {size:.3g} bytes, and at most {MOST_BYTES:.3g} are read")
        return path.read_bytes()
    except OSError as error:
        raise MeshFileError(f"it cannot be read ({error.strerror})") from None


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
