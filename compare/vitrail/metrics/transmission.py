"""What a tinted glass lets pass: transmittance per channel, and the colour of what passed."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.colour_difference import chromaticity, delta_e_2000, lab
from vitrail.metrics.measurement import Context, Measurement, MetricError, per_channel
from vitrail.metrics.radiance import patch_mean


def transmittance(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Mean radiance of the patch over what it shows with nothing in the way: ``transmittance.<channel>``.

    An absolute quantity; nothing without ``context.full_radiance``, and nothing in a comparison, where
    ``radiance_ratio`` is the ratio of transmittances. A channel without light to begin with is left out.
    """
    if reference is not None or context.full_radiance is None:
        return []
    full = np.asarray(context.full_radiance, float)
    lit = full > 0
    share = np.divide(patch_mean(candidate), full, out=np.zeros(3), where=lit)
    found = per_channel("transmittance", share, "1", None, settings={"full_radiance": tuple(full.tolist())})
    return [m for m, is_lit in zip(found, lit, strict=True) if is_lit]


def chromaticity_shift(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Colour without brightness, CIE 1976: ``chromaticity.u/.v``, or ``chromaticity_shift.u/.v`` with ideal 0.

    ``u`` and ``v`` are the colour coordinates u' and v' here. Raises MetricError on a black patch.
    """
    ours = _chromaticity(candidate)
    if reference is None:
        return [Measurement(f"chromaticity.{n}", float(x), "1", None) for n, x in zip("uv", ours, strict=True)]
    theirs = _chromaticity(reference)
    parts = {"distance": float(np.hypot(*(ours - theirs)))}
    return [
        Measurement(f"chromaticity_shift.{n}", float(x - y), "1", 0.0, parts=parts)
        for n, x, y in zip("uv", ours, theirs, strict=True)
    ]


def colour_difference(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """CIEDE2000 between the mean colours of the patches: ``delta_e_2000``, ideal 0, below 1 hardly visible.

    White is ``context.full_radiance`` (its largest channel), or else the largest channel of the reference; the same
    for both images.
    """
    if reference is None:
        return []
    theirs = patch_mean(reference)
    white = float(max(context.full_radiance)) if context.full_radiance is not None else float(theirs.max())
    if not white > 0:
        raise MetricError("the reference patch is black and has no colour; give full_radiance")
    value = float(delta_e_2000(lab(patch_mean(candidate) / white), lab(theirs / white)))
    return [Measurement("delta_e_2000", value, "1", 0.0, {"white": white, "illuminant": "D65"})]


def _chromaticity(samples: PatchSamples) -> np.ndarray:
    found = chromaticity(patch_mean(samples))
    if not np.isfinite(found).all():
        raise MetricError("the patch is black and has no chromaticity; correct the patch, or look why it is dark")
    return found
