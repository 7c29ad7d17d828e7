"""Light that reached a surface by way of other diffuse surfaces."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Context, Measurement, MetricError, per_channel
from vitrail.metrics.profile import PhenomenonLight, light_of
from vitrail.metrics.radiance import RADIANCE, channel_ratios


def indirect_light(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Mean indirect radiance of the patch.

    Absolute: ``indirect_radiance.<channel>``; comparison: ``indirect_ratio.<channel>``, ideal 1. Raises MetricError
    when neither image has any.
    """
    light, other = light_of(("indirect_light",), candidate, reference, context)
    settings = light.settings
    if reference is None or other is None:
        return per_channel(
            "indirect_radiance", _mean(light, candidate), RADIANCE, None, settings=settings, caveats=light.caveats
        )
    ratios = channel_ratios("indirect_ratio", _mean(light, candidate), _mean(other, reference), settings, light.caveats)
    if not ratios:
        raise MetricError("neither image has indirect light on the patch; correct the patch or the scene")
    return ratios


def _mean(light: PhenomenonLight, samples: PatchSamples) -> np.ndarray:
    weight = samples.coverage[..., None]
    return (light.values * weight).sum(axis=(0, 1)) / weight.sum()
