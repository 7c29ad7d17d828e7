"""Structural similarity, single and multi-scale, always of display values under a named transform.

On linear radiance SSIM measures noise before it measures anything else, and without an explicit ``data_range`` it has
been published wrong for years; here both are fixed.
"""

from __future__ import annotations

import numpy as np
from skimage.metrics import structural_similarity

from vitrail.images.display import Display
from vitrail.metrics.measurement import Measurement, MetricError

WINDOW = 11
SIGMA = 1.5
SETTINGS = {"data_range": 1.0, "gaussian_sigma_px": SIGMA, "window_px": WINDOW, "k1": 0.01, "k2": 0.03}
"""Those of Wang, Bovik, Sheikh, Simoncelli 2004, IEEE TIP 13(4)."""

SCALE_WEIGHTS = (0.0448, 0.2856, 0.3001, 0.2363, 0.1333)
"""Finest first: Wang, Simoncelli, Bovik 2003, Asilomar, table 1."""


def ssim(candidate: np.ndarray, reference: np.ndarray, display: Display) -> Measurement:
    """Mean SSIM of two radiance images (height, width, 3); ideal 1. Raises MetricError on sizes and NaN."""
    ours, theirs = _displayed(candidate, reference, display)
    return Measurement("ssim", _similarity(ours, theirs), "1", 1.0, {**SETTINGS, **display.settings()})


def multi_scale_ssim(candidate: np.ndarray, reference: np.ndarray, display: Display) -> Measurement:
    """Multi-scale SSIM; ideal 1. ``parts`` holds the contrast-structure term of each scale and the last luminance term.

    An image too small for five scales uses fewer, with their weights scaled to sum to 1, and says so.
    """
    ours, theirs = _displayed(candidate, reference, display)
    scales = min(len(SCALE_WEIGHTS), int(np.log2(min(ours.shape[:2]) / WINDOW)) + 1)
    weights = np.array(SCALE_WEIGHTS[:scales]) / sum(SCALE_WEIGHTS[:scales])
    terms = []
    for scale in range(scales):
        # The coarsest scale also carries luminance; the finer ones contrast and structure only.
        terms.append(_similarity(ours, theirs) if scale == scales - 1 else _contrast_structure(ours, theirs))
        ours, theirs = _halved(ours), _halved(theirs)
    # A negative correlation has no real power; it counts as no similarity at all.
    value = float(np.prod(np.maximum(terms, 0.0) ** weights))
    caveats = (
        () if scales == len(SCALE_WEIGHTS) else (f"the image has room for {scales} of {len(SCALE_WEIGHTS)} scales",)
    )
    settings = {**SETTINGS, "scale_weights": tuple(float(w) for w in weights), **display.settings()}
    return Measurement("ms_ssim", value, "1", 1.0, settings, {"scales": tuple(terms)}, caveats)


def _displayed(candidate: np.ndarray, reference: np.ndarray, display: Display) -> tuple[np.ndarray, np.ndarray]:
    if candidate.shape != reference.shape:
        raise MetricError(f"images differ in size: {candidate.shape} and {reference.shape}; render both alike")
    if min(candidate.shape[:2]) < WINDOW:
        raise MetricError(f"SSIM needs at least {WINDOW} pixels each way, the image has {candidate.shape[:2]}")
    if not (np.isfinite(candidate).all() and np.isfinite(reference).all()):
        raise MetricError("NaN or infinity in an image; it must fail its gate before SSIM")
    return display.apply(candidate), display.apply(reference)


def _similarity(ours: np.ndarray, theirs: np.ndarray, k1: float = 0.01) -> float:
    return float(
        structural_similarity(
            ours,
            theirs,
            data_range=1.0,
            channel_axis=2,
            gaussian_weights=True,
            sigma=SIGMA,
            use_sample_covariance=False,
            K1=k1,
            K2=0.03,
        )
    )


def _contrast_structure(ours: np.ndarray, theirs: np.ndarray) -> float:
    """SSIM without its luminance term: a huge K1 makes (2 mu mu' + C1) / (mu^2 + mu'^2 + C1) equal 1 to 1e-12."""
    return _similarity(ours, theirs, k1=1e6)


def _halved(picture: np.ndarray) -> np.ndarray:
    """Mean of 2 x 2 pixels; an odd last row or column is dropped."""
    rows, columns = picture.shape[0] // 2 * 2, picture.shape[1] // 2 * 2
    even = picture[:rows, :columns]
    return even.reshape(rows // 2, 2, columns // 2, 2, -1).mean(axis=(1, 3))
