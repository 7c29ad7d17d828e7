"""Write the overcast sky of scenes/calibration as a lat-long EXR image.

    python tools/overcast.py scenes/calibration/overcast.exr

The standard overcast sky of the CIE (Moon and Spencer, 1942): radiance Lz (1 + 2 sin g) / 3 at the elevation g, and
nothing from below the horizon. A pixel holds its mean over the solid angle it covers, so that rows keep their power.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from vitrail.images.exr import write_image

ROWS, COLUMNS = 32, 64
ZENITH = (0.85, 1.0, 1.2)
"""Radiance straight up, W sr^-1 m^-2: the faint blue of an overcast sky."""


def row_radiance() -> np.ndarray:
    """Radiance of each row for a zenith of 1, from the top down (ROWS,)."""
    edges = np.sin(np.pi / 2 - np.pi * np.arange(ROWS + 1) / ROWS)
    # The mean of (1 + 2 s) / 3 over s = sin g, in which solid angle is even.
    return np.where(edges[1:] >= -1e-12, (1 + edges[:-1] + edges[1:]) / 3, 0.0)


def main(path: Path) -> None:
    sky = row_radiance()[:, None, None] * np.array(ZENITH)
    write_image(path, np.broadcast_to(sky, (ROWS, COLUMNS, 3)).astype(np.float32))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
