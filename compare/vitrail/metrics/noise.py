"""From two half-images to an interval on every number, and to what a metric reads when noise alone differs.

Half the difference of two independent halves has the law of the noise of their mean. The patch is cut into blocks of
about equal noise; each block's noise is added to the image on its own and the metric is taken again. The sum of the
squared changes is the variance of the metric: exactly for a linear one, to first order for any smooth one, without
a random number. Blocks are larger than the noise is correlated (the gather radius), or variance would be missed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Context, Interval, Measurement, MetricError

PatchMetric = Callable[[PatchSamples, PatchSamples | None, Context], list[Measurement]]

BLOCKS = 32
"""Per image: the standard error is then itself known to 1 / sqrt(2 * 32) = 12 %, and Student's t allows for it."""

LEAST_SIDE = 4
"""Cells along the side of a block at least, since neighbouring cells share pixels."""

SIDE_PER_CORRELATION = 3
"""A block this many correlation lengths wide misses about a tenth of the variance to its neighbours."""

METHOD = "block jackknife of the half difference"


def with_interval(
    metric: PatchMetric,
    candidate: PatchSamples,
    reference: PatchSamples | None,
    context: Context,
    *,
    level: float = 0.95,
    blocks: int = BLOCKS,
) -> list[Measurement]:
    """The measurements of ``metric``, each with its interval at confidence ``level`` and, for a comparison, its floor.

    An image without halves adds no noise and says so in a caveat; a number that a disturbed image does not yield again
    has no interval. Raises what ``metric`` raises.
    """
    found = metric(candidate, reference, context)
    images = [image for image in (candidate, reference) if image is not None]
    silent = sum(image.noise is None for image in images)
    if silent == len(images):
        return [m.with_caveat("no half images, so the noise is not known") for m in found]
    changes = _changes(metric, candidate, reference, context, blocks, found)
    floors = noise_floor(metric, candidate, reference, context)
    found = [
        replace(m, interval=_interval(m.value, changes[m.metric], level), floor=floors.get(m.metric)) for m in found
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


def noise_blocks(noise: np.ndarray, cells: tuple[float, float], correlation_m: float, blocks: int) -> np.ndarray:
    """(nv, nu) block numbers from 0: the patch halved again and again so that each part holds equal noise power.

    ``cells`` are the edges (v, u) of a cell in metres. No side is shorter than the noise is correlated.
    """
    power = (noise**2).sum(axis=-1) + np.finfo(float).tiny
    least = [
        max(LEAST_SIDE, SIDE_PER_CORRELATION * max(_correlation_cells(noise, axis), correlation_m / cells[axis]))
        for axis in (0, 1)
    ]
    labels = np.zeros(power.shape, int)
    parts = [(0, power.shape[0], 0, power.shape[1])]
    while len(parts) < blocks:
        # Halve the part with the most noise that can still be halved.
        sizes = [
            power[a:b, c:d].sum() if _axis_to_cut((a, b, c, d), least) is not None else -1.0 for a, b, c, d in parts
        ]
        largest = int(np.argmax(sizes))
        if sizes[largest] < 0:
            break
        parts += _halved(power, parts.pop(largest), least)
    for number, (a, b, c, d) in enumerate(parts):
        labels[a:b, c:d] = number
    return labels


def _axis_to_cut(part: tuple[int, int, int, int], least: list[float]) -> int | None:
    """The longer side, in units of the least block, if two blocks fit along it."""
    a, b, c, d = part
    room = [(b - a) / least[0], (d - c) / least[1]]
    axis = int(np.argmax(room))
    return axis if room[axis] >= 2 else None


def _halved(power: np.ndarray, part: tuple[int, int, int, int], least: list[float]) -> list[tuple[int, int, int, int]]:
    a, b, c, d = part
    axis = _axis_to_cut(part, least)
    assert axis is not None
    line = power[a:b, c:d].sum(axis=1 - axis)
    # Cut where half the noise lies to either side, but leave each side its least width.
    side = int(np.ceil(least[axis]))
    cut = int(np.clip(np.searchsorted(np.cumsum(line), line.sum() / 2) + 1, side, line.size - side))
    if axis == 0:
        return [(a, a + cut, c, d), (a + cut, b, c, d)]
    return [(a, b, c, c + cut), (a, b, c + cut, d)]


def _correlation_cells(noise: np.ndarray, axis: int) -> float:
    """The length, in cells, over which noise stays alike: one-sided sum of its correlation until that is lost."""
    total, power = 0.0, float((noise**2).mean())
    if power == 0:
        return 1.0
    moved = np.moveaxis(noise, axis, 0)
    for lag in range(1, max(2, moved.shape[0] // 4)):
        alike = float((moved[lag:] * moved[:-lag]).mean()) / power
        # Below the scatter of the estimate itself there is nothing left to add.
        if alike < max(0.05, 2 / np.sqrt(moved[lag:].size)):
            break
        total += alike
    return 1.0 + total


def _changes(
    metric: PatchMetric,
    candidate: PatchSamples,
    reference: PatchSamples | None,
    context: Context,
    blocks: int,
    found: list[Measurement],
) -> dict[str, list[float] | None]:
    """How each number moves when one block's noise is added once more; None where it cannot be measured again."""
    changes: dict[str, list[float] | None] = {m.metric: [] for m in found}
    for image in (candidate, reference):
        if image is None or image.noise is None:
            continue
        noise = image.noise
        labels = noise_blocks(noise, (image.cell_v_m, image.cell_u_m), context.correlation_m, blocks)
        for number in range(labels.max() + 1):
            moved = image.disturbed(noise * (labels == number)[..., None])
            pair = (moved, reference) if image is candidate else (candidate, moved)
            try:
                again = {m.metric: m.value for m in metric(*pair, context)}
            except MetricError:
                again = {}
            for m in found:
                known = changes[m.metric]
                if m.metric not in again:
                    changes[m.metric] = None
                elif known is not None:
                    known.append(again[m.metric] - m.value)
    return changes


def _interval(value: float, changes: list[float] | None, level: float) -> Interval | None:
    """Student's t, with the degrees of freedom that so many unequal contributions are worth [Satterthwaite 1946]."""
    if changes is None or not changes:
        return None
    squares = np.square(changes)
    variance = float(squares.sum())
    if variance == 0:
        return Interval.about(value, 0.0, float("inf"), level, METHOD)
    # Each square estimates its block's variance with one degree; E[x^4] = 3 sigma^4 makes up the 3 and the 2.
    dof = float(np.clip(3 * variance**2 / np.square(squares).sum() - 2, 1.0, len(changes)))
    return Interval.about(value, float(np.sqrt(variance)), dof, level, METHOD)


def _or_zero(image: PatchSamples) -> np.ndarray:
    return np.zeros_like(image.values) if image.noise is None else image.noise


def _like(candidate: PatchSamples, reference: PatchSamples, offset: np.ndarray) -> PatchSamples:
    """The reference's light in the candidate's place, and its layers where both have them: both are read alike."""
    layers = {name: reference.layers[name] for name in candidate.layers if name in reference.layers}
    extra = {name: layer for name, layer in candidate.layers.items() if name not in layers}
    moved = replace(candidate, values=reference.values, layers=layers).disturbed(offset)
    return replace(moved, layers={**moved.layers, **extra})
