"""A mesh as its file says it, before it is placed: vertices, normals, and polygons."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vitrail.geometry.polygon_cut import triangles_of


@dataclass(frozen=True)
class RawMesh:
    """Vertices (n, 3) as written, normals (n, 3) or None, and faces as lists of indices or as triangles (m, 3)."""

    vertices: np.ndarray
    normals: np.ndarray | None
    faces: list[list[int]] | np.ndarray

    def triangles(self) -> np.ndarray:
        """Indices (m, 3). Raises ValueError for a face without vertices or an outline that crosses itself."""
        if isinstance(self.faces, np.ndarray):
            return self._known(self.faces)
        self._known(np.array([each for face in self.faces for each in face], int))
        found = [each for face in self.faces for each in triangles_of(face, self.vertices)]
        return np.array(found, int).reshape(-1, 3)

    def _known(self, faces: np.ndarray) -> np.ndarray:
        if faces.size and (faces.min() < 0 or faces.max() >= len(self.vertices)):
            raise ValueError(f"a face names a vertex that is not among its {len(self.vertices)}")
        return faces
