"""How much a rough face blurs an edge that is seen through it or in it."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.edge import Edge, fit_edge
from vitrail.metrics.measurement import Context, Measurement, MetricError
from vitrail.metrics.profile import cell_m, degrees_at, profile


def blur(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Standard deviation of the Gaussian that best blurs a sharp step into the edge nearest to the patch centre.

    Absolute: ``blur`` in metres on the patch and, with ``context.throw_m`` (from the rough face to the pattern),
    ``blur_deg``. Comparison: ``blur_ratio``, ideal 1; where the reference is sharp to a tenth of a cell, ``blur_shift``
    in metres, ideal 0. The average of the picture over a cell is not counted as blur.
    """
    ours = _edge(candidate, context)
    settings = {"along": context.along, "model": "Gaussian"}
    if reference is None:
        found = [Measurement("blur", ours.sigma_m, "m", None, settings)]
        if context.throw_m is not None:
            degrees = degrees_at(ours.sigma_m, context.throw_m)
            found.append(Measurement("blur_deg", degrees, "deg", None, {**settings, "throw_m": context.throw_m}))
        return found
    theirs = _edge(reference, context)
    parts = {"candidate": ours.sigma_m, "reference": theirs.sigma_m}
    if theirs.sigma_m < 0.1 * cell_m(reference, context.along):
        return [Measurement("blur_shift", ours.sigma_m - theirs.sigma_m, "m", 0.0, settings, parts)]
    return [Measurement("blur_ratio", ours.sigma_m / theirs.sigma_m, "1", 1.0, settings, parts)]


def contrast(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Standard deviation of the profile over its mean: ``contrast``, or ``contrast_ratio`` with ideal 1.

    It needs no edge: blur that reaches past the neighbours of an edge shows here when none is left to fit.
    """
    ours = _contrast(candidate, context)
    if reference is None:
        return [Measurement("contrast", ours, "1", None, {"along": context.along})]
    theirs = _contrast(reference, context)
    if not theirs > 0:
        raise MetricError("the reference shows no contrast; put the patch across an edge of the pattern")
    parts = {"candidate": ours, "reference": theirs}
    return [Measurement("contrast_ratio", ours / theirs, "1", 1.0, {"along": context.along}, parts)]


def _edge(samples: PatchSamples, context: Context) -> Edge:
    x, channels = profile(samples.values, samples, context.along)
    return fit_edge(x, channels.mean(axis=-1), cell_m(samples, context.along))


def _contrast(samples: PatchSamples, context: Context) -> float:
    grey = profile(samples.values, samples, context.along)[1].mean(axis=-1)
    if not grey.mean() > 0:
        raise MetricError("the patch is black; it has no contrast")
    return float(np.std(grey) / grey.mean())
