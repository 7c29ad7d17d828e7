"""A mesh as its file says it, before it is placed: vertices, normals, and polygons."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class RawMesh:
    """Vertices (n, 3) as written, normals (n, 3) or None, and faces: ``corners`` of all of them, one after the other.

    ``counts`` says how many corners each face has.
    """

    vertices: np.ndarray
    normals: np.ndarray | None
    corners: np.ndarray
    counts: np.ndarray

    def __post_init__(self) -> None:
        if self.corners.size and (self.corners.min() < 0 or self.corners.max() >= len(self.vertices)):
            raise ValueError(f"a face names a vertex that is not among its {len(self.vertices)}")
