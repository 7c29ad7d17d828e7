"""The light of a patch as it is: mean radiance per channel, its ratio to a reference, and how even it is."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Context, Measurement, MetricError, per_channel

RADIANCE = "W sr^-1 m^-2"


def patch_mean(samples: PatchSamples) -> np.ndarray:
    """Mean radiance per channel (3,), each cell weighted by the share of it that is in the frame."""
    weight = samples.coverage[..., None]
    if not weight.sum() > 0:
        raise MetricError("the patch is outside the image; move the patch or the camera")
    return (samples.values * weight).sum(axis=(0, 1)) / weight.sum()


def mean_radiance(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Absolute: ``mean_radiance.<channel>`` of one image. Comparison: ``radiance_ratio.<channel>``, ideal 1."""
    if reference is None:
        return per_channel("mean_radiance", patch_mean(candidate), RADIANCE, None)
    ours, theirs = patch_mean(candidate), patch_mean(reference)
    lit = theirs > 0
    # A channel without light has no ratio; say so by leaving it out, unless only the reference is dark.
    if np.any(~lit & (ours > 0)):
        raise MetricError("the reference patch is black where the candidate is not; compare mean_radiance instead")
    both = per_channel("radiance_ratio", np.divide(ours, theirs, out=np.ones(3), where=lit), "1", 1.0)
    return [m for m, is_lit in zip(both, lit, strict=True) if is_lit]
