"""The light of a patch as it is: mean radiance per channel, and its ratio to a reference."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import CHANNELS, Context, Measurement, MetricError, per_channel

RADIANCE = "W sr^-1 m^-2"

DARK_SHARE = 1e-6
"""A channel with less than this share of the brightest one is dark; it also bounds every ratio: 1e-6 to 1e6."""


def patch_mean(samples: PatchSamples) -> np.ndarray:
    """Mean radiance per channel (3,), each cell weighted by the share of it that is in the frame."""
    weight = samples.coverage[..., None]
    if not weight.sum() > 0:
        raise MetricError("the patch is outside the image; move the patch or the camera")
    return (samples.values * weight).sum(axis=(0, 1)) / weight.sum()


def channel_ratios(
    family: str, ours: np.ndarray, theirs: np.ndarray, settings: Mapping[str, object], caveats: tuple[str, ...] = ()
) -> list[Measurement]:
    """``family.<channel>`` = ours / theirs, ideal 1; a channel that is dark in both images is left out.

    Light that only one image has must not vanish in a division: the darker side counts as at least ``DARK_SHARE`` of
    the brightest channel, so the ratio is then far from 1 and finite.
    """
    least = DARK_SHARE * max(float(ours.max()), float(theirs.max()), 0.0)
    found = []
    for channel, a, b in zip(CHANNELS, ours, theirs, strict=True):
        if max(a, b) > least:
            dark = ("one of the two has no light in this channel",) if min(a, b) <= least else ()
            parts = {"candidate": float(a), "reference": float(b)}
            value = float(max(a, least) / max(b, least)) if dark else float(a / b)
            found.append(Measurement(f"{family}.{channel}", value, "1", 1.0, settings, parts, caveats + dark))
    return found


def mean_radiance(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Absolute: ``mean_radiance.<channel>`` of one image. Comparison: ``radiance_ratio.<channel>``, ideal 1."""
    if reference is None:
        return per_channel("mean_radiance", patch_mean(candidate), RADIANCE, None)
    return channel_ratios("radiance_ratio", patch_mean(candidate), patch_mean(reference), {})


def mean_difference(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """``mean_difference.<channel>``, candidate less reference, W sr^-1 m^-2, ideal 0; of dark patches too."""
    if reference is None:
        raise MetricError("a difference needs two images; give a reference")
    return per_channel("mean_difference", patch_mean(candidate) - patch_mean(reference), RADIANCE, 0.0)
