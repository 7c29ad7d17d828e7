"""Energy: in a uniform surround everything that only scatters looks like the surround."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import CHANNELS, Context, Measurement
from vitrail.metrics.radiance import patch_mean


def furnace_deviation(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Mean radiance over ``context.furnace_radiance``, less 1: ``furnace_deviation.<channel>``, ideal 0.

    Positive: energy was made. Negative: it was lost, which is right for glass that absorbs. It has an ideal although it
    is a quantity of one image. Nothing without a furnace; nothing in a comparison.
    """
    if reference is not None or context.furnace_radiance is None:
        return []
    furnace = np.asarray(context.furnace_radiance, float)
    mean = patch_mean(candidate)
    settings = {"furnace_radiance": tuple(furnace.tolist())}
    return [
        Measurement(f"furnace_deviation.{c}", float(ours / full - 1), "1", 0.0, settings)
        for c, ours, full in zip(CHANNELS, mean, furnace, strict=True)
        if full > 0
    ]
