"""Linear Rec. 709 colours as luminance, XYZ, Lab and colour differences. White is D65 at (1, 1, 1)."""

from __future__ import annotations

from typing import Any

import numpy as np

RGB_TO_XYZ = np.array(
    [
        [0.4123907992659595, 0.35758433938387796, 0.1804807884018343],
        [0.21263900587151036, 0.7151686787677559, 0.07219231536073371],
        [0.01933081871559185, 0.11919477979462599, 0.9505321522496606],
    ]
)
"""Rec. 709 primaries with D65 at x = 0.3127, y = 0.3290, derived from the chromaticities in double precision."""

WHITE_XYZ = RGB_TO_XYZ.sum(axis=1)


def luminance(rgb: Any) -> np.ndarray:
    """Relative luminance Y (...) of linear colours (..., 3)."""
    return np.asarray(rgb, float) @ RGB_TO_XYZ[1]


def xyz(rgb: Any) -> np.ndarray:
    """CIE XYZ (..., 3) of linear colours (..., 3); white has Y = 1."""
    return np.asarray(rgb, float) @ RGB_TO_XYZ.T


def chromaticity(rgb: Any) -> np.ndarray:
    """CIE x, y (..., 2) of linear colours; NaN for black."""
    values = xyz(rgb)
    with np.errstate(invalid="ignore", divide="ignore"):
        return values[..., :2] / values.sum(axis=-1, keepdims=True)


def lab(rgb: Any) -> np.ndarray:
    """CIE 1976 L*a*b* (..., 3) of linear colours, with white at L* = 100 [CIE 15:2018, 8.2.1]."""
    ratio = xyz(rgb) / WHITE_XYZ
    f = np.where(ratio > (6 / 29) ** 3, np.cbrt(ratio), ratio / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.stack(
        [116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])],
        axis=-1,
    )


def delta_e_2000(first_rgb: Any, second_rgb: Any) -> np.ndarray:
    """CIEDE2000 difference (...) of two linear colours (..., 3)."""
    import warnings

    # Import late: the package takes a second to load, and few commands need it.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from colour.difference import delta_E_CIE2000

        return np.asarray(delta_E_CIE2000(lab(first_rgb), lab(second_rgb)))
