"""From two half-images to an interval on every number, and to what a metric reads when noise alone differs.

Half the difference of two independent halves has the law of the noise of their mean. ``noise_model`` learns that law:
how strong it is where, how far it is alike, how the channels go together. Then the metric is taken again on images
with fresh noise of that law added, and the spread of its readings is the standard error; a metric that noise biases
is spread by its bias too. Draws are a fixed sequence, so the same images always give the same interval.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import repeat

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Context, Measurement, MetricError, PatchMetric, StudentInterval
from vitrail.metrics.noise_model import NoiseModel, learn_noise

DRAWS = 48
"""Times the metric is taken again; a standard error from so many is good to 1 / sqrt(96) = 10 %."""

MOST_DEGREES = 24.0
"""The law itself is learnt from one difference, locally to about 10 %: together as good as so many degrees."""

METHOD = "metric repeated on noise of the measured law"


def with_interval(
    metric: PatchMetric,
    candidate: PatchSamples,
    reference: PatchSamples | None,
    context: Context,
    *,
    near: PatchMetric | None = None,
    level: float = 0.95,
    draws: int = DRAWS,
) -> list[Measurement]:
    """The measurements of ``metric``, each with its interval at confidence ``level`` and, for a comparison, its floor.

    ``near`` gives the numbers of ``metric``, faster, for images that differ from these by their noise.
    An image without halves adds no noise and says so in a caveat; a number that a noisier image does not yield again
    has no interval. Raises what ``metric`` raises.
    """
    found = metric(candidate, reference, context)
    images = [image for image in (candidate, reference) if image is not None]
    silent = sum(image.noise is None for image in images)
    if silent == len(images):
        return [m.with_caveat("no half images, so the noise is not known") for m in found]
    errors = _standard_errors(near or metric, candidate, reference, context, found, draws)
    floors = noise_floor(metric, candidate, reference, context)
    found = [
        replace(m, interval=_interval(m.value, errors.get(m.metric), level), floor=floors.get(m.metric)) for m in found
    ]
    if silent:
        found = [m.with_caveat("one image has no halves; its noise is not in the interval") for m in found]
    return found


def noise_floor(
    metric: PatchMetric, candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> dict[str, float]:
    """What a comparison reads when noise alone separates the images: the A/A value by metric name.

    Two copies of the reference are set apart by exactly the difference of the two noises. Empty without a reference.
    """
    if reference is None:
        return {}
    apart = _or_zero(candidate) - _or_zero(reference)
    try:
        found = metric(_like(candidate, reference, apart / 2), reference.disturbed(-apart / 2), context)
    except MetricError:
        return {}
    return {m.metric: m.value for m in found}


def _standard_errors(
    metric: PatchMetric,
    candidate: PatchSamples,
    reference: PatchSamples | None,
    context: Context,
    found: list[Measurement],
    draws: int,
) -> dict[str, float]:
    """Root mean square change of each number under fresh noise; names that a draw does not yield are left out."""
    ours = learn_noise(candidate, context.correlation_m)
    theirs = None if reference is None else learn_noise(reference, context.correlation_m)
    if not any(model is not None and model.is_loud for model in (ours, theirs)):
        return {m.metric: 0.0 for m in found}
    values = {m.metric: m.value for m in found}
    squares = dict.fromkeys(values, 0.0)
    others = repeat(None) if reference is None else _redrawn(reference, theirs, draws, 1)
    for moved, other in zip(_redrawn(candidate, ours, draws, 0), others, strict=False):
        try:
            again = {m.metric: m.value for m in metric(moved, other, context)}
        except MetricError:
            return {}
        squares = {name: total + (again[name] - values[name]) ** 2 for name, total in squares.items() if name in again}
    return {name: float(np.sqrt(total / draws)) for name, total in squares.items()}


def _redrawn(image: PatchSamples, model: NoiseModel | None, draws: int, seed: int) -> Iterator[PatchSamples]:
    """The image ``draws`` times, each with other noise of its law added."""
    if model is None or not model.is_loud:
        return repeat(image, draws)
    return (image.disturbed(noise) for noise in model.draws(draws, seed))


def _interval(value: float, standard_error: float | None, level: float) -> StudentInterval | None:
    if standard_error is None:
        return None
    degrees = MOST_DEGREES if standard_error > 0 else float("inf")
    return StudentInterval.about(value, standard_error, degrees, level, METHOD)


def _or_zero(image: PatchSamples) -> np.ndarray:
    return np.zeros_like(image.values) if image.noise is None else image.noise


def _like(candidate: PatchSamples, reference: PatchSamples, offset: np.ndarray) -> PatchSamples:
    """The reference's light in the candidate's place, and its layers where both have them: both are read alike."""
    layers = {name: reference.layers[name] for name in candidate.layers if name in reference.layers}
    extra = {name: layer for name, layer in candidate.layers.items() if name not in layers}
    moved = replace(candidate, values=reference.values, layers=layers).disturbed(offset)
    return replace(moved, layers={**moved.layers, **extra})
