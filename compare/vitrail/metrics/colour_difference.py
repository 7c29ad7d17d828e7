"""From linear Rec. 709 to CIE colours and their differences."""

from __future__ import annotations

import numpy as np
from skimage.color import deltaE_ciede2000

XYZ_OF_RGB = np.array(
    [
        [0.412390799265959, 0.357584339383878, 0.180480788401834],
        [0.212639005871510, 0.715168678767756, 0.072192315360734],
        [0.019330818715592, 0.119194779794626, 0.950532152249661],
    ]
)
"""Linear Rec. 709 with white D65 (x, y) = (.3127, .3290) to XYZ, Y of white = 1 [ITU-R BT.709]."""

WHITE = XYZ_OF_RGB.sum(axis=1)


def lab(rgb: np.ndarray) -> np.ndarray:
    """CIE L*a*b* (..., 3) of linear RGB where 1 is white under D65. Negative XYZ follows the curve's straight part."""
    share = np.asarray(rgb, float) @ XYZ_OF_RGB.T / WHITE
    # The straight part below (6/29)^3 is the tangent of the cube root [CIE 15].
    low = share <= (6 / 29) ** 3
    curve = np.where(low, share * (29 / 6) ** 2 / 3 + 4 / 29, np.cbrt(np.where(low, 1.0, share)))
    fx, fy, fz = np.moveaxis(curve, -1, 0)
    return np.stack([116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)], axis=-1)


def delta_e_2000(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """CIEDE2000 with kL = kC = kH = 1 between L*a*b* colours (..., 3)."""
    return np.asarray(deltaE_ciede2000(first, second))


def chromaticity(rgb: np.ndarray) -> np.ndarray:
    """CIE 1976 (u', v') of linear RGB (..., 3): the colour without its brightness. Black gives NaN."""
    x, y, z = np.moveaxis(np.asarray(rgb, float) @ XYZ_OF_RGB.T, -1, 0)
    with np.errstate(invalid="ignore", divide="ignore"):
        total = x + 15 * y + 3 * z
        return np.stack([4 * x / total, 9 * y / total], axis=-1)
