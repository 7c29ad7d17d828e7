"""HDR-FLIP: what a person would notice when flipping between two images [Andersson et al. 2021, EGSR].

Its automatic exposures look at the image (a black background moves them by 16 stops) and it swallows NaN, so here the
exposures are always given and non-finite images are refused.
"""

from __future__ import annotations

import os
from dataclasses import asdict, dataclass

import numpy as np

# Let FLIP's threads sleep while they wait: spinning, they take four times as long on a machine that is busy rendering.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

import flip_evaluator  # noqa: E402

from vitrail.images.display import Display
from vitrail.metrics.measurement import Measurement, MetricError


@dataclass(frozen=True)
class FlipSettings:
    """Exposures in stops, tone mapper, pixels per degree (67: 0.7 m away from a screen of 3840 on 0.7 m)."""

    start_exposure: float
    stop_exposure: float
    exposures: int
    pixels_per_degree: float = 67.0
    tone_mapper: str = "ACES"

    @classmethod
    def around(cls, display: Display) -> FlipSettings:
        """Five exposures, two stops to either side of the scene's own; radiance is first divided by its white."""
        return cls(display.exposure_stops - 2.0, display.exposure_stops + 2.0, 5)


def flip_map(candidate: np.ndarray, reference: np.ndarray, settings: FlipSettings) -> np.ndarray:
    """The error of each pixel (height, width), 0 alike to 1. Raises MetricError on sizes, NaN and infinity."""
    if candidate.shape != reference.shape:
        raise MetricError(f"images differ in size: {candidate.shape} and {reference.shape}; render both alike")
    if not (np.isfinite(candidate).all() and np.isfinite(reference).all()):
        raise MetricError("NaN or infinity in an image; it must fail its gate before FLIP")
    if settings.exposures < 2 or not settings.start_exposure < settings.stop_exposure:
        raise MetricError("HDR-FLIP needs at least two exposures, in ascending order")
    # Negative radiance (saturated spectral colours in linear RGB) has no display value; FLIP itself takes none.
    pair = [np.ascontiguousarray(np.maximum(a, 0.0), dtype=np.float32) for a in (reference, candidate)]
    parameters = {
        "startExposure": float(settings.start_exposure),
        "stopExposure": float(settings.stop_exposure),
        "numExposures": int(settings.exposures),
        "ppd": float(settings.pixels_per_degree),
        "tonemapper": settings.tone_mapper,
    }
    errors, _, used = flip_evaluator.evaluate(*pair, "HDR", applyMagma=False, parameters=parameters)
    for key in ("startExposure", "stopExposure", "numExposures"):
        if abs(used[key] - parameters[key]) > 1e-5:
            raise MetricError(f"FLIP used {key} = {used[key]} instead of {parameters[key]}; its version is not ours")
    return np.asarray(errors, float).reshape(candidate.shape[:2])


def flip(candidate: np.ndarray, reference: np.ndarray, display: Display) -> Measurement:
    """Mean HDR-FLIP of two radiance images (height, width, 3); ideal 0."""
    settings = FlipSettings.around(display)
    errors = flip_map(candidate / display.white, reference / display.white, settings)
    caveats = ("negative radiance was taken as 0",) if min(candidate.min(), reference.min()) < 0 else ()
    parts = {"median": float(np.median(errors)), "p99": float(np.quantile(errors, 0.99)), "max": float(errors.max())}
    return Measurement(
        "flip", float(errors.mean()), "1", 0.0, {**asdict(settings), "white": display.white}, parts, caveats
    )
