"""How often a mesh encloses a point: what a line from it meets, found in the shadow of the mesh across that line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_ACROSS, _ASIDE = np.array([0.7549, -0.6180, 0.2195]), np.array([0.2, 0.5698, 0.7966])
_PER_CELL = 2
"""Cells of the plane for each face."""
_AT_ONCE = 1 << 12
"""Points that are asked together."""


@dataclass(frozen=True, eq=False)
class Shadow:
    """Faces (m, 3, 3) turned so that the line is the third axis, and which of them fall on each cell of the plane."""

    corners: np.ndarray
    low: np.ndarray
    per_m: float
    shape: tuple[int, int]
    first: np.ndarray
    faces: np.ndarray

    @classmethod
    def of(cls, corners: np.ndarray) -> Shadow:
        """Sort faces with an area into cells by the boxes around their shadows."""
        turned = corners @ _turn().T
        flat = turned[..., :2]
        least, most = flat.min(axis=1), flat.max(axis=1)
        low, size = least.min(axis=0), most.max(axis=0) - least.min(axis=0)
        per_m = float(np.sqrt(_PER_CELL * len(corners) / np.prod(size)))
        shape = tuple(int(each) + 1 for each in size * per_m)
        begin, end = ((each - low) * per_m for each in (least, most))
        begin, end = begin.astype(int), end.astype(int)
        # List every face once for each cell that its box covers.
        across, up = (end - begin + 1).T
        faces = np.repeat(np.arange(len(corners)), across * up)
        place = np.arange(len(faces)) - np.repeat(np.cumsum(across * up) - across * up, across * up)
        x, y = begin[faces, 0] + place % across[faces], begin[faces, 1] + place // across[faces]
        cell = x * shape[1] + y
        order = np.argsort(cell, kind="stable")
        first = np.searchsorted(cell[order], np.arange(shape[0] * shape[1] + 1))
        return cls(turned, low, per_m, (shape[0], shape[1]), first, faces[order])

    def winding(self, points: np.ndarray) -> np.ndarray:
        """What goes out less what comes in along the line from each point, (n,)."""
        eyes = points @ _turn().T
        found = np.zeros(len(eyes), int)
        for start in range(0, len(eyes), _AT_ONCE):
            found[start : start + _AT_ONCE] = self._winding(eyes[start : start + _AT_ONCE])
        return found

    def _winding(self, eyes: np.ndarray) -> np.ndarray:
        place = np.floor((eyes[:, :2] - self.low) * self.per_m).astype(int)
        covered = ((place >= 0) & (place < self.shape)).all(axis=1)
        cell = np.where(covered, place[:, 0] * self.shape[1] + place[:, 1], 0)
        count = np.where(covered, self.first[cell + 1] - self.first[cell], 0)
        which = np.repeat(np.arange(len(eyes)), count)
        nth = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
        seen = self.corners[self.faces[self.first[cell][which] + nth]] - eyes[which][:, None]
        # A face is met where the three edges are passed on the same side, and ahead where its height is.
        a, b, c = seen[:, 0], seen[:, 1], seen[:, 2]
        u, v, w = _cross(b, c), _cross(c, a), _cross(a, b)
        area, height = u + v + w, u * a[:, 2] + v * b[:, 2] + w * c[:, 2]
        meets = ((u > 0) & (v > 0) & (w > 0)) | ((u < 0) & (v < 0) & (w < 0))
        out = np.where(meets & (height * area > 0), np.sign(area), 0)
        return np.bincount(which, weights=out, minlength=len(eyes)).astype(int)


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of the first two coordinates."""
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def _turn() -> np.ndarray:
    """A rotation that brings a line without any zero, which no edge is likely to be along, to the third axis."""
    x = _ACROSS / np.linalg.norm(_ACROSS)
    z = np.cross(x, _ASIDE)
    z /= np.linalg.norm(z)
    return np.array([x, np.cross(z, x), z])
