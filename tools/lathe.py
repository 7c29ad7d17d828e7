"""Turn a profile about the y axis into a closed triangle mesh: the vase of scenes/paper/backlit_vase.yaml.

    python tools/lathe.py > scenes/paper/vase.ply

The profile runs from the axis at the bottom outside, up to the rim, and down inside to the axis again: the glass
lies on its left and the triangles face outwards. Every bend is rounded by splines, because smooth normals need it.
"""

from __future__ import annotations

import sys

import numpy as np
from scipy.interpolate import CubicSpline

AROUND = 72
"""Corners around the axis, 5 degrees each."""

ALONG = 56
"""Rings between the two points on the axis."""

# Outline of the vase: radius and height in metres, outside from the foot to the rim, then inside.
OUTLINE = np.array(
    [
        [0.000, 0.000], [0.030, 0.000], [0.045, 0.004], [0.050, 0.020], [0.060, 0.060], [0.072, 0.110], [0.068, 0.160],
        [0.048, 0.205], [0.036, 0.235], [0.040, 0.262], [0.052, 0.280], [0.0535, 0.2825], [0.052, 0.284],
        [0.0495, 0.2815], [0.037, 0.264], [0.0325, 0.235], [0.0445, 0.203], [0.064, 0.158], [0.067, 0.110],
        [0.054, 0.062], [0.044, 0.028], [0.034, 0.018], [0.018, 0.015], [0.000, 0.0145],
    ]
)  # fmt: skip


def profile() -> np.ndarray:
    """(ALONG + 2, 2) points of the outline, evenly spaced along it, level where it meets the axis."""
    length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(OUTLINE, axis=0).T))])
    level = ((1, [1.0, 0.0]), (1, [-1.0, 0.0]))
    points = CubicSpline(length, OUTLINE, bc_type=level)(np.linspace(0, length[-1], ALONG + 2))
    points[[0, -1], 0] = 0
    return points


def lathe(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (n, 3) and triangles (m, 3), counter-clockwise seen from outside the glass."""
    angles = 2 * np.pi * np.arange(AROUND) / AROUND
    circle = np.stack([np.cos(angles), np.zeros(AROUND), np.sin(angles)], axis=-1)
    rings = points[1:-1, 0][:, None, None] * circle + np.array([0, 1, 0]) * points[1:-1, 1][:, None, None]
    ends = np.array([[0, points[0, 1], 0], [0, points[-1, 1], 0]])
    vertices = np.concatenate([rings.reshape(-1, 3), ends])
    first, last = len(vertices) - 2, len(vertices) - 1
    faces = []
    for k in range(AROUND):
        after = (k + 1) % AROUND
        faces.append((first, k, after))
        faces.append((last, (ALONG - 1) * AROUND + after, (ALONG - 1) * AROUND + k))
        for ring in range(ALONG - 1):
            a, b = ring * AROUND + k, ring * AROUND + after
            faces += [(a, a + AROUND, b), (b, a + AROUND, b + AROUND)]
    return vertices, np.array(faces)


def volume(vertices: np.ndarray, faces: np.ndarray) -> float:
    """Signed volume; positive when the triangles face outwards."""
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    return float((np.cross(a, b) * c).sum() / 6)


def write_ply(vertices: np.ndarray, faces: np.ndarray) -> str:
    header = ["ply", "format ascii 1.0", "comment A vase, made by tools/lathe.py", f"element vertex {len(vertices)}"]
    header += [f"property double {axis}" for axis in "xyz"]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    lines = [" ".join(f"{value:.7g}" for value in vertex + 0.0) for vertex in vertices]
    lines += ["3 " + " ".join(str(index) for index in face) for face in faces]
    return "\n".join(header + lines) + "\n"


if __name__ == "__main__":
    made = lathe(profile())
    assert volume(*made) > 0, "the triangles face inwards"
    sys.stdout.write(write_ply(*made))
