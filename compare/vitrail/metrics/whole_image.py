"""The global metrics of two whole images: the second list, beside the one by phenomenon.

They are shown beside the verdicts and are none themselves: a vanished caustic leaves SSIM at .97.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from vitrail.images.display import Display
from vitrail.images.exr import ImageLayers
from vitrail.metrics.errors import colour_error, relative_l1, relative_mse
from vitrail.metrics.flip import flip
from vitrail.metrics.measurement import Measurement
from vitrail.metrics.ssim import multi_scale_ssim, ssim

ImageMetric = Callable[[np.ndarray, np.ndarray, Display], Measurement]
Halves = tuple[np.ndarray, np.ndarray]

WHOLE_IMAGE: tuple[ImageMetric, ...] = (ssim, multi_scale_ssim, flip, relative_mse, relative_l1, colour_error)


def measure_image(candidate: ImageLayers, reference: ImageLayers, display: Display) -> list[Measurement]:
    """Every global metric, each with its floor: what it reads when the noise of the two images alone differs.

    Raises MetricError on images that should have failed a gate (sizes, NaN).
    """
    found = [metric(candidate.radiance, reference.radiance, display) for metric in WHOLE_IMAGE]
    halves = [_halves(image) for image in (candidate, reference)]
    known = [pair for pair in halves if pair is not None]
    if not known:
        return [m.with_caveat("no half images, so the noise floor is not known") for m in found]
    caveats = () if len(known) == 2 else ("one image has no halves; its noise is not in the floor",)
    return [
        replace(m, floor=_floor(metric, m, reference.radiance, known, display), caveats=m.caveats + caveats)
        for metric, m in zip(WHOLE_IMAGE, found, strict=True)
    ]


def _floor(
    metric: ImageMetric, measured: Measurement, base: np.ndarray, halves: list[Halves], display: Display
) -> float:
    """The A/A value: what the metric reads of two images that differ by the noise of these two.

    A similarity S divides by the variance of each picture, so noise that both share would hide it; of independent
    halves 1 / S - 1 is proportional to the noise variance, and each pair of halves differs by four times that of its
    mean. The errors take a difference: two copies of one picture set apart by the noise give it directly.
    """
    if measured.ideal == 1.0:
        excess = sum(1 / max(metric(a, b, display).value, 1e-6) - 1 for a, b in halves) / 4
        return 1 / (1 + excess)
    apart = (halves[0][0] - halves[0][1]) / 2
    for a, b in halves[1:]:
        apart = apart - (a - b) / 2
    # Keep the copies as dark as pictures are: noise below 0 exists in the halves only.
    return metric(np.maximum(base + apart / 2, 0), np.maximum(base - apart / 2, 0), display).value


def _halves(image: ImageLayers) -> Halves | None:
    return None if image.half_a is None or image.half_b is None else (image.half_a, image.half_b)
