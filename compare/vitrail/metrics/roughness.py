"""How much a rough face blurs an edge that is seen through it or in it, and what contrast it leaves of a pattern."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.edge import Edge, fit_edge
from vitrail.metrics.measurement import Context, Measurement, MetricError, PatchMetric
from vitrail.metrics.profile import cell_m, degrees_at, profile

SHARP = 0.1
"""Cells of blur below which an edge is sharp: a ratio to nothing says nothing."""

PLATEAU = 1.5
"""Standard deviations from an edge to the ends of what is fitted, at least: 93 % of its step is then seen. With less, a
wide edge with a high step looks like a narrow one with a low step, and noise decides between them."""

MOST_PARTS = 16
"""Parts of a profile that contrast is taken of: finer grain is noise, which adds to it."""

HALF = 0.5
"""Contrast from which on it is compared as a ratio. There 2 % of it are 1 % of full contrast, the tolerance below."""


def blur(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Standard deviation of the Gaussian that best blurs a sharp step into the edge nearest to the patch centre.

    Absolute: ``blur`` in metres on the patch and, with ``context.throw_m`` (from the rough face to the pattern),
    ``blur_deg``. Comparison: ``blur_ratio``, ideal 1; where the reference is sharp to a tenth of a cell, ``blur_shift``
    in metres, ideal 0. The average of the picture over a cell is not counted as blur. Raises MetricError where no edge
    stands out of the noise, and where its blur reaches past the patch or the neighbouring edges.
    """
    if reference is None:
        ours = _edge(candidate, context)
        settings = _settings(context)
        found = [Measurement("blur", ours.sigma_m, "m", None, settings)]
        if context.throw_m is not None:
            degrees = degrees_at(ours.sigma_m, context.throw_m)
            found.append(Measurement("blur_deg", degrees, "deg", None, {**settings, "throw_m": context.throw_m}))
        return found
    return [_blurs(candidate, reference, context, is_sharp=_is_sharp(reference, context))]


def blur_near(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> PatchMetric:
    """``blur`` of images that differ little from these: a ratio, or a shift, as here."""
    if reference is None:
        return blur
    is_sharp = _is_sharp(reference, context)

    def again(ours: PatchSamples, theirs: PatchSamples | None, known: Context) -> list[Measurement]:
        return blur(ours, None, known) if theirs is None else [_blurs(ours, theirs, known, is_sharp=is_sharp)]

    return again


def contrast(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Standard deviation of the profile over its mean: 1 for a pattern of equal black and white stripes.

    Absolute: ``contrast``. Comparison: ``contrast_ratio``, ideal 1; where the reference has less than half of full
    contrast, ``contrast_shift``, ideal 0, because a ratio of two remnants is a ratio of noise. It needs no edge: blur
    that reaches past the neighbours of an edge shows here when none is left to fit.
    """
    if reference is None:
        return [Measurement("contrast", _contrast(candidate, context), "1", None, {"along": context.along})]
    return [_contrasts(candidate, reference, context, is_high=_contrast(reference, context) >= HALF)]


def contrast_near(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> PatchMetric:
    """``contrast`` of images that differ little from these: a ratio, or a shift, as here."""
    if reference is None:
        return contrast
    is_high = _contrast(reference, context) >= HALF

    def again(ours: PatchSamples, theirs: PatchSamples | None, known: Context) -> list[Measurement]:
        return contrast(ours, None, known) if theirs is None else [_contrasts(ours, theirs, known, is_high=is_high)]

    return again


def _blurs(ours: PatchSamples, theirs: PatchSamples, context: Context, *, is_sharp: bool) -> Measurement:
    sigmas = [_edge(each, context).sigma_m for each in (ours, theirs)]
    parts = dict(zip(("candidate", "reference"), sigmas, strict=True))
    if is_sharp:
        return Measurement("blur_shift", sigmas[0] - sigmas[1], "m", 0.0, _settings(context), parts)
    return Measurement("blur_ratio", sigmas[0] / sigmas[1], "1", 1.0, _settings(context), parts)


def _contrasts(ours: PatchSamples, theirs: PatchSamples, context: Context, *, is_high: bool) -> Measurement:
    found = [_contrast(each, context) for each in (ours, theirs)]
    parts, settings = dict(zip(("candidate", "reference"), found, strict=True)), {"along": context.along}
    if is_high:
        return Measurement("contrast_ratio", found[0] / found[1], "1", 1.0, settings, parts)
    return Measurement("contrast_shift", found[0] - found[1], "1", 0.0, settings, parts)


def _settings(context: Context) -> dict[str, object]:
    return {"along": context.along, "model": "Gaussian"}


def _is_sharp(samples: PatchSamples, context: Context) -> bool:
    return _edge(samples, context).sigma_m < SHARP * cell_m(samples, context.along)


def _edge(samples: PatchSamples, context: Context) -> Edge:
    x, grey = _grey(samples.values, samples, context)
    noise = None if samples.noise is None else _grey(samples.noise, samples, context)[1]
    edge = fit_edge(x, grey, cell_m(samples, context.along), noise=noise)
    if PLATEAU * edge.sigma_m > min(edge.position_m - edge.from_m, edge.to_m - edge.position_m):
        raise MetricError("the blur reaches past the patch or the neighbouring edges; contrast tells how much is left")
    return edge


def _contrast(samples: PatchSamples, context: Context) -> float:
    grey = _grey(samples.values, samples, context)[1]
    if not grey.mean() > 0:
        raise MetricError("the patch is black; it has no contrast")
    parts = np.array([part.mean() for part in np.array_split(grey, min(grey.size, MOST_PARTS))])
    return float(np.std(parts) / grey.mean())


def _grey(values: np.ndarray, samples: PatchSamples, context: Context) -> tuple[np.ndarray, np.ndarray]:
    x, channels = profile(values, samples, context.along)
    return x, channels.mean(axis=-1)
