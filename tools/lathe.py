"""Turn a profile about the y axis into a closed triangle mesh: the vase, the goblet and its wine of scenes/paper.

    python tools/lathe.py vase > scenes/paper/vase.ply        # also: goblet, wine

A profile runs from the axis at the bottom outside, up to the rim, and down inside to the axis again: the glass
lies on its left and the triangles face outwards. Every bend is rounded by splines, because smooth normals need it.
"""

from __future__ import annotations

import sys

import numpy as np
from scipy.interpolate import CubicSpline

AROUND = 72
"""Corners around the axis, 5 degrees each."""

ALONG = {"vase": 56, "goblet": 128, "wine": 40}
"""Rings between the two points on the axis."""

BEND_M = 0.02
"""In the goblet a bend of one radian gets as many rings as so many metres: its rim is narrower than the rings are apart
elsewhere, and with rings evenly apart the inside of the thin wall comes out through its outside."""

FINE = 20000
"""Places at which a curve is measured."""

# Outlines: radius and height in metres, outside from the foot to the rim, then inside.
VASE = np.array(
    [
        [0.000, 0.000], [0.030, 0.000], [0.045, 0.004], [0.050, 0.020], [0.060, 0.060], [0.072, 0.110], [0.068, 0.160],
        [0.048, 0.205], [0.036, 0.235], [0.040, 0.262], [0.052, 0.280], [0.0535, 0.2825], [0.052, 0.284],
        [0.0495, 0.2815], [0.037, 0.264], [0.0325, 0.235], [0.0445, 0.203], [0.064, 0.158], [0.067, 0.110],
        [0.054, 0.062], [0.044, 0.028], [0.034, 0.018], [0.018, 0.015], [0.000, 0.0145],
    ]
)  # fmt: skip
GOBLET_OUTSIDE = np.array(
    [
        [0.000, 0.000], [0.020, 0.000], [0.032, 0.000], [0.0352, 0.0006], [0.0355, 0.0016], [0.033, 0.0026],
        [0.022, 0.0042], [0.012, 0.0068], [0.0064, 0.0120], [0.0044, 0.0240], [0.0040, 0.0450], [0.0042, 0.0640],
        [0.0058, 0.0780], [0.0120, 0.0880], [0.0240, 0.0975], [0.0345, 0.1120], [0.0400, 0.1310], [0.0402, 0.1500],
        [0.0378, 0.1720], [0.0362, 0.1825], [0.0350, 0.1900], [0.0345, 0.1940],
    ]
)  # fmt: skip
GOBLET_RIM = np.array([[0.0342, 0.1957], [0.0339, 0.19595], [0.0336, 0.1956]])
GOBLET_INSIDE = np.array(
    [
        [0.0335, 0.1940], [0.0340, 0.1900], [0.0352, 0.1824], [0.0368, 0.1718],
        [0.0390, 0.1499], [0.0388, 0.1313], [0.0334, 0.1131], [0.0232, 0.0992],
        [0.0115, 0.0908], [0.0050, 0.0888], [0.000, 0.0884],
    ]
)  # fmt: skip
WINE_LEVEL_M = 0.1400
WINE_INTO_WALL_M = 0.0004
"""How far the wine reaches into the wall, so that no two faces coincide."""


def profile(name: str = "vase") -> np.ndarray:
    """(rings + 2, 2) points of an outline, radius and height in metres, from the axis to the axis."""
    rings = ALONG[name]
    if name == "vase":
        return spline(VASE, rings + 2)
    goblet = np.concatenate([GOBLET_OUTSIDE, GOBLET_RIM, GOBLET_INSIDE])
    return spline(goblet, rings + 2, BEND_M) if name == "goblet" else _wine(goblet, rings + 2)


def spline(outline: np.ndarray, count: int, bend_m: float = 0.0) -> np.ndarray:
    """``count`` points along a smooth curve through an outline, level where it meets the axis.

    They are evenly spaced but for bends: one of a radian counts as ``bend_m`` metres.
    """
    length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(outline, axis=0).T))])
    level = ((1, [1.0, 0.0]), (1, [-1.0, 0.0]))
    curve = CubicSpline(length, outline, bc_type=level)
    fine = np.linspace(0, length[-1], FINE)
    way = np.diff(curve(fine), axis=0)
    bend = np.abs(np.diff(np.unwrap(np.arctan2(way[:, 1], way[:, 0])), prepend=0))
    spent = np.concatenate([[0], np.cumsum(np.diff(fine) + bend_m * bend)])
    points = curve(np.interp(np.linspace(0, spent[-1], count), spent, fine))
    points[[0, -1], 0] = 0
    return points


def _wine(goblet: np.ndarray, count: int) -> np.ndarray:
    """The inside of the goblet up to the level, moved into the wall, and a flat top with a crisp edge."""
    fine = spline(goblet, 4000)
    inside = fine[np.argmax(fine[:, 1]) :][::-1]
    along = np.gradient(inside, axis=0)
    normal = np.stack([along[:, 1], -along[:, 0]], axis=-1) / np.hypot(*along.T)[:, None]
    wall = (inside + WINE_INTO_WALL_M * normal)[inside[:, 1] < WINE_LEVEL_M]
    radius = wall[-1, 0]
    top = radius * np.array([1.0, 0.998, 0.98, 0.9, 0.7, 0.45, 0.2, 0.0])
    rest = wall[np.linspace(0, len(wall) - 1, count - len(top)).astype(int)]
    rest[0, 0] = 0
    return np.concatenate([rest, np.stack([top, np.full(len(top), WINE_LEVEL_M)], axis=-1)])


def lathe(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (n, 3) and triangles (m, 3), counter-clockwise seen from outside the glass."""
    rings_along = len(points) - 2
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
        faces.append((last, (rings_along - 1) * AROUND + after, (rings_along - 1) * AROUND + k))
        for ring in range(rings_along - 1):
            a, b = ring * AROUND + k, ring * AROUND + after
            faces += [(a, a + AROUND, b), (b, a + AROUND, b + AROUND)]
    return vertices, np.array(faces)


def volume(vertices: np.ndarray, faces: np.ndarray) -> float:
    """Signed volume; positive when the triangles face outwards."""
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    return float((np.cross(a, b) * c).sum() / 6)


def write_ply(vertices: np.ndarray, faces: np.ndarray, name: str = "vase") -> str:
    header = ["ply", "format ascii 1.0", f"comment A {name}, made by tools/lathe.py", f"element vertex {len(vertices)}"]
    header += [f"property double {axis}" for axis in "xyz"]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    lines = [" ".join(f"{value:.7g}" for value in vertex + 0.0) for vertex in vertices]
    lines += ["3 " + " ".join(str(index) for index in face) for face in faces]
    return "\n".join(header + lines) + "\n"


if __name__ == "__main__":
    wanted = sys.argv[1] if len(sys.argv) > 1 else "vase"
    made = lathe(profile(wanted))
    assert volume(*made) > 0, "the triangles face inwards"
    sys.stdout.write(write_ply(*made, wanted))
