"""Where in a whole picture two images differ by more than their noise and what is stated: every place, by region.

A patch answers what somebody asked; this looks everywhere else. The difference is averaged over square boxes of several
sizes. Its noise is learnt from the halves: half their difference has the law of the noise, one draw of it a pixel, so
its squares are averaged over the boxes around. What is left of the difference beyond a tolerance, over that noise, is
held against the quantile that a picture without any deviation passes once in ``1 / FALSE_ALARM_RATE`` pictures.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import correlate1d, find_objects, label, uniform_filter
from scipy.special import stdtrit

from vitrail.metrics.measurement import MetricError

BOXES_PX = (5, 15, 45)
"""Edges of the boxes. The small ones find what is bright and small, the large ones what is weak and wide."""

MOST_OF_PICTURE = 0.25
"""Share of the picture's shorter side that a box takes at most: its noise is learnt from others around it."""

AROUND = 7
"""Edge, in boxes, of the square from which the noise of a box is learnt."""

DEGREES = 24.0
"""What a variance from 49 boxes of two images is worth where a gather disc is as wide as two boxes: a quarter of 98."""

STOPS_ALIKE = 2.0
"""Boxes within a factor of 4 in brightness are alike: what is dark has other noise than a caustic beside it."""

FEWEST_BOXES = 12
"""Fewer boxes alike than this do not say how noisy they are."""

FALSE_ALARM_RATE = 1e-3
"""Pictures of equal engines in which a region is named by chance."""

ROUNDING = 2.0**-11
"""Share of the light by which a half float may be wrong, in all pixels of an even wall alike: that is no difference."""

EDGE_SHARE = 0.4
"""Share of the step over three pixels that a pixel may be wrong by. Halves see edges alike, so no noise shows there: it
stands for an edge half a pixel elsewhere, also for a box that holds only the rim of what such a step spans."""

BY_CHANCE = 2.0
"""Standard deviations of chance above which a step common to both halves is one: noise passes in 2 % of pixels."""

GROWTH = 0.5
"""A region goes on to where half the threshold is passed, so that it has its true size."""

HEIGHT_AT = 0.9
"""The quantile of the differences in a region that counts as its height: the largest is noise."""

CORE_SHARE = 0.5
"""Share of that height down to which a region goes: an edge that a box smooths passes there where it is."""

DARK_SHARE = 1e-4
"""Share of the picture's mean light below which nothing is seen: what a display of 13 bits leaves black."""


@dataclass(frozen=True)
class DifferentRegion:
    """A connected region (``mask``, (height, width)) with its means over it, W sr^-1 m^-2, mean of the channels.

    ``difference`` is candidate less reference, ``tolerance`` what was allowed of it, ``standard_error`` its noise;
    ``excess`` the largest of what is left over, in standard errors of a box.
    """

    mask: np.ndarray
    candidate: float
    reference: float
    tolerance: float
    standard_error: float
    excess: float

    @property
    def pixels(self) -> int:
        return int(self.mask.sum())

    @property
    def difference(self) -> float:
        return self.candidate - self.reference


@dataclass(frozen=True)
class Scan:
    """``over_noise`` (height, width): the signed difference of the smallest boxes over its noise and rounding.

    ``threshold`` is what the excess must pass, in standard errors. Regions come largest difference of light first.
    """

    over_noise: np.ndarray
    threshold: float
    regions: tuple[DifferentRegion, ...]


Halves = tuple[np.ndarray, np.ndarray]


def scan(
    candidate: np.ndarray, reference: np.ndarray, halves: tuple[Halves, Halves], allowed: np.ndarray | float
) -> Scan:
    """Hold two pictures (height, width, 3) against each other; ``halves`` of each, ``allowed`` relative to the light.

    ``allowed`` (height, width) is what may differ, as a share of the larger of the two. Raises MetricError on sizes,
    and on pictures smaller than four of the smallest box.
    """
    boxes = [box for box in BOXES_PX if box <= MOST_OF_PICTURE * min(candidate.shape[:2])]
    if candidate.shape != reference.shape or not boxes:
        raise MetricError(f"pictures of {candidate.shape} and {reference.shape} cannot be scanned; they must be alike")
    ours, theirs = candidate.mean(axis=-1), reference.mean(axis=-1)
    noise = [(a - b).mean(axis=-1) / 2 for a, b in halves]
    light = np.maximum(np.abs(ours), np.abs(theirs))
    dark = DARK_SHARE * float(light.mean())
    steps = [_step(*(half.mean(axis=-1) for half in pair)) for pair in halves]
    tolerance = np.maximum(allowed * light, dark) + EDGE_SHARE * np.maximum(*steps)
    threshold = _threshold(ours.size, boxes)
    excess = np.stack([_excess(ours - theirs, noise, light, tolerance, box) for box in boxes])
    over_noise = _over_noise(ours - theirs, noise, light, boxes[0])
    most, smooth = excess.max(axis=0), _mean(ours - theirs, boxes[0])
    masks = [_core(mask, smooth) for mask in _regions(most, threshold)]
    found = [_region(mask, ours, theirs, noise, tolerance, most) for mask in masks]
    found.sort(key=lambda each: -abs(each.difference) * each.pixels)
    return Scan(over_noise, threshold, tuple(found))


def _step(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """The step over three pixels that both halves have: the product of their noises is 0 in the mean.

    It is below 0 by chance as often as above, so what is below 0 around says what chance does.
    """
    square = np.zeros_like(first)
    for axis in (0, 1):
        one, other = (correlate1d(half, (-1.0, 0.0, 1.0), axis=axis, mode="nearest") for half in (first, second))
        square += one * other
    square = _mean(square, 3)
    chance = np.sqrt(2 * _mean(np.minimum(square, 0.0) ** 2, AROUND * BOXES_PX[0]))
    return np.sqrt(np.maximum(square - BY_CHANCE * chance, 0.0))


def _threshold(pixels: int, boxes: list[int]) -> float:
    """The quantile for as many tests as there are boxes of each size, on both sides of 0."""
    tests = 2 * sum(pixels / box**2 for box in boxes)
    return -float(stdtrit(DEGREES, FALSE_ALARM_RATE / tests))


def _box_error(noise: list[np.ndarray], light: np.ndarray, box: int) -> np.ndarray:
    """The standard error of the mean difference of each box.

    It is learnt from boxes around that are about as bright, as variance over light, which is one number where photons
    are counted; a box with few of those around also counts as noisy as all that are there. A box whose own noise is
    larger than theirs has a bright speck in one half; it is as noisy as it is.
    """
    own = sum(_mean(each, box) ** 2 for each in noise)
    around = np.maximum(_mean(light, box), np.finfo(float).tiny)
    stops = np.floor(np.log2(around) / STOPS_ALIKE)
    wide, factor = AROUND * box, np.zeros_like(light)
    for stop in np.unique(stops):
        alike = stops == stop
        share = _mean(alike.astype(float), wide)
        within = _over(_mean(np.where(alike, own / around, 0.0), wide), share)
        every = np.where(share * AROUND**2 < FEWEST_BOXES, _mean(own / around, wide), 0.0)
        factor = np.where(alike, np.maximum(within, every), factor)
    return np.sqrt(factor * around + own)


def _mean(values: np.ndarray, edge: int) -> np.ndarray:
    """The mean of the square around each pixel; what running sums leave below 0 is 0 where no value is below."""
    mean: np.ndarray = uniform_filter(values, edge, mode="reflect")
    return np.maximum(mean, 0.0) if values.min() >= 0 else mean


def _over_noise(difference: np.ndarray, noise: list[np.ndarray], light: np.ndarray, box: int) -> np.ndarray:
    error = np.hypot(_box_error(noise, light, box), ROUNDING * np.abs(_mean(light, box)))
    return _over(_mean(difference, box), error)


def _excess(
    difference: np.ndarray, noise: list[np.ndarray], light: np.ndarray, tolerance: np.ndarray, box: int
) -> np.ndarray:
    """What is left of the difference of each box beyond the tolerance, in standard errors."""
    left = np.abs(_mean(difference, box)) - _mean(tolerance, box)
    return _over(np.maximum(left, 0.0), _box_error(noise, light, box))


def _over(value: np.ndarray, error: np.ndarray) -> np.ndarray:
    """A quotient where both may be 0; what differs without any noise differs beyond all."""
    most = np.sign(value) * np.finfo(np.float32).max
    return np.divide(value, error, out=np.where(value == 0, 0.0, most), where=error > 0)


def _regions(excess: np.ndarray, threshold: float) -> list[np.ndarray]:
    """Connected regions above the share ``GROWTH`` of the threshold that pass it somewhere."""
    numbers, _ = label(excess > GROWTH * threshold, structure=np.ones((3, 3)))
    passing = set(np.unique(numbers[excess > threshold]).tolist())
    return [numbers == number for number in sorted(passing)]


def _core(mask: np.ndarray, difference: np.ndarray) -> np.ndarray:
    """The part of a region that has at least half of its difference: large boxes see it from beyond its border."""
    sign = np.sign(difference[mask].sum())
    height = float(np.quantile(sign * difference[mask], HEIGHT_AT))
    return mask & (sign * difference >= CORE_SHARE * height)


def _region(
    mask: np.ndarray,
    ours: np.ndarray,
    theirs: np.ndarray,
    noise: list[np.ndarray],
    tolerance: np.ndarray,
    excess: np.ndarray,
) -> DifferentRegion:
    error = np.sqrt(sum(float(each[mask].mean()) ** 2 for each in noise))
    candidate, reference, allowed = (float(each[mask].mean()) for each in (ours, theirs, tolerance))
    return DifferentRegion(mask, candidate, reference, allowed, float(error), float(excess[mask].max()))


def layer_of(region: DifferentRegion, difference: np.ndarray, layers: dict[str, np.ndarray]) -> str:
    """The layer whose light is most like the difference (height, width, 3) in and around a region; "" without layers.

    The difference is taken as a multiple of the layer's light, in a box twice as large as the region.
    """
    rows, columns = _box_around(region.mask)
    change = difference[rows, columns].mean(axis=-1)
    explained = {}
    for name, layer in layers.items():
        light = layer[rows, columns].mean(axis=-1)
        power = float((light**2).sum())
        explained[name] = float((light * change).sum()) ** 2 / power if power > 0 else 0.0
    best = max(explained, key=lambda name: explained[name], default="")
    return best if best and explained[best] > 0 else ""


def _box_around(mask: np.ndarray) -> tuple[slice, slice]:
    """The box of a region, half its size larger on every side."""
    found = find_objects(mask.astype(np.int8))[0]
    sides = []
    for part, size in zip(found, mask.shape, strict=True):
        more = (part.stop - part.start + 1) // 2
        sides.append(slice(max(0, part.start - more), min(size, part.stop + more)))
    return sides[0], sides[1]
