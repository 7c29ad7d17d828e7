"""Beer-Lambert absorption: optical depth and absorption coefficient from light that crossed a known thickness."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import CHANNELS, Context, Measurement, MetricError
from vitrail.metrics.profile import profile
from vitrail.metrics.radiance import patch_mean

LEAST_LIGHT = 1e-9
"""Below this share of the brightest channel a logarithm measures rounding and no glass."""


def optical_depth(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """-ln of the share of light that is left.

    Absolute: ``optical_depth.<channel>`` from ``context.full_radiance``, and with ``context.thickness_m``
    ``absorption.<channel>`` in 1/m (Fresnel losses count as absorption; a fit over a wedge does not have them).
    Comparison: ``optical_depth_shift.<channel>`` = ln(reference / candidate), ideal 0.
    """
    ours = patch_mean(candidate)
    if reference is not None:
        theirs = patch_mean(reference)
        lit = (ours > LEAST_LIGHT * ours.max()) & (theirs > LEAST_LIGHT * theirs.max())
        if not lit.any():
            raise MetricError("no channel has light in both images; the optical depth is beyond measure")
        return [
            Measurement(f"optical_depth_shift.{c}", float(np.log(b / a)), "1", 0.0)
            for c, a, b, is_lit in zip(CHANNELS, ours, theirs, lit, strict=True)
            if is_lit
        ]
    if context.full_radiance is None:
        return []
    found = []
    for channel, left, full in zip(CHANNELS, ours, context.full_radiance, strict=True):
        if left > 0 and full > 0:
            depth = float(np.log(full / left))
            found.append(Measurement(f"optical_depth.{channel}", depth, "1"))
            if context.thickness_m is not None:
                settings = {"thickness_m": context.thickness_m}
                found.append(Measurement(f"absorption.{channel}", depth / context.thickness_m, "m^-1", None, settings))
    return found


def absorption_fit(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Slope of -ln radiance against thickness along a wedge, 1/m: the light's strength and every constant loss cancel.

    Absolute: ``absorption_fit.<channel>``; comparison: ``absorption_fit_shift.<channel>``, ideal 0. Nothing without
    ``context.thickness_slope`` (metres of glass per metre along the patch).
    """
    if context.thickness_slope is None or context.thickness_slope == 0:
        return []
    settings = {"along": context.along, "thickness_slope": context.thickness_slope}
    ours = _slopes(candidate, context)
    if reference is None:
        return [Measurement(f"absorption_fit.{c}", x, "m^-1", None, settings) for c, x in ours.items()]
    theirs = _slopes(reference, context)
    return [
        Measurement(
            f"absorption_fit_shift.{c}", x - theirs[c], "m^-1", 0.0, settings, {"candidate": x, "reference": theirs[c]}
        )
        for c, x in ours.items()
        if c in theirs
    ]


def _slopes(samples: PatchSamples, context: Context) -> dict[str, float]:
    """Absorption per metre of each channel that is lit along the whole patch.

    Cells are weighted by their radiance squared, as if all had the same noise: a dark end must not rule the fit.
    """
    assert context.thickness_slope is not None
    x, radiance = profile(samples.values, samples, context.along)
    found = {}
    for channel, column in zip(CHANNELS, radiance.T, strict=True):
        if column.min() > 0:
            slope = np.polyfit(x * context.thickness_slope, -np.log(column), 1, w=column)[0]
            found[channel] = float(slope)
    if not found:
        raise MetricError("no channel is lit along the whole wedge; choose a thinner part of it")
    return found
