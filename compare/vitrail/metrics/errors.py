"""Whole-image errors of radiance: relative mean square, relative L1, and colour difference."""

from __future__ import annotations

import numpy as np

from vitrail.images.display import Display
from vitrail.metrics.colour_difference import delta_e_2000, lab
from vitrail.metrics.measurement import Measurement, MetricError

EPSILON = 0.01
"""Keeps dark pixels from ruling the mean: (a tenth of display white) squared [Rousselle et al. 2011, TOG 30(6)]."""


def _checked(candidate: np.ndarray, reference: np.ndarray) -> None:
    if candidate.shape != reference.shape:
        raise MetricError(f"images differ in size: {candidate.shape} and {reference.shape}; render both alike")
    if not (np.isfinite(candidate).all() and np.isfinite(reference).all()):
        raise MetricError("NaN or infinity in an image; it must fail its gate before any error is computed")


def relative_mse(candidate: np.ndarray, reference: np.ndarray, display: Display) -> Measurement:
    """Mean of (c - r)^2 / (r^2 + epsilon), with epsilon on the scale of display white; ideal 0.

    Noise of either image adds its variance; the floor of the measurement says how much.
    """
    _checked(candidate, reference)
    white = display.white / 2.0**display.exposure_stops
    value = np.mean((candidate - reference) ** 2 / (reference**2 + EPSILON * white**2))
    return Measurement("relmse", float(value), "1", 0.0, {"epsilon": EPSILON * white**2})


def relative_l1(candidate: np.ndarray, reference: np.ndarray, display: Display) -> Measurement:
    """Sum of |c - r| over the sum of |r|; ideal 0. The exposure plays no part in it."""
    _checked(candidate, reference)
    total = np.abs(reference).sum()
    if total == 0:
        raise MetricError("the reference image is black; no relative error exists")
    return Measurement("relative_l1", float(np.abs(candidate - reference).sum() / total), "1", 0.0, {})


def colour_error(candidate: np.ndarray, reference: np.ndarray, display: Display) -> Measurement:
    """Mean CIEDE2000 over the pixels, colours relative to display white, not clipped; ideal 0."""
    _checked(candidate, reference)
    scale = 2.0**display.exposure_stops / display.white
    difference = delta_e_2000(lab(candidate * scale), lab(reference * scale))
    parts = {"p95": float(np.quantile(difference, 0.95))}
    settings = {"white": display.white, "exposure_stops": display.exposure_stops, "illuminant": "D65"}
    return Measurement("delta_e_2000", float(difference.mean()), "1", 0.0, settings, parts)
