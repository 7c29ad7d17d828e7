"""Where two pictures show a pattern that stands out of their noise, so that a move of it can be seen."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import MetricError

SMOOTHING_CELLS = 1.0
"""Both pictures are blurred this much first: a sharp edge in cells is not band-limited, and a spline cannot move it."""

LEAST_OVER_NOISE = 10.0
"""Square slopes of pattern and noise over those of the noise: the fit is then linear in the noise to some percent."""

LEAST_TEXTURE = 1e-3
"""A direction with less than this share of the other's gradient has no pattern to register."""

LEAST_STEEPNESS = 0.2
"""Least slope of a pattern, in its mean light per patch: below it the rounding of half floats, .05 % of the light,
reads as a move of .25 % of the patch, which is the size of the tolerance."""

NOISE_SIGMAS = 3.0
"""A pattern is there where the square slopes exceed those of the noise by this many standard deviations of theirs."""

ROUNDED = 5e-4
"""What half floats round, of the light of the brightest channel: none is quieter, and one that is nearly dark weighs
little. Behind dark glass it shows another picture."""

CELLS_ALIKE = 4 * np.pi * SMOOTHING_CELLS**2
"""Cells over which the smoothing makes noise alike: the integral of a Gaussian's square correlation, twice."""


def channel_weights(candidate: PatchSamples, reference: PatchSamples) -> np.ndarray:
    """What each channel weighs in the pictures that are registered (3,): its light over the variance of its noise.

    That is the sum in which a pattern, alike in all channels, stands out most. Without noise all weigh alike.
    """
    images = (candidate, reference)
    light = np.sum([np.abs(image.values).mean(axis=(0, 1)) for image in images], axis=0)
    noises = [image.noise for image in images if image.noise is not None]
    if not noises or not light.any():
        return np.full(3, 1 / 3)
    variance = np.sum([(noise**2).mean(axis=(0, 1)) for noise in noises], axis=0) + (ROUNDED * light.max()) ** 2
    weights = light / variance
    return np.asarray(weights / weights.sum())


def usable_axes(candidate: PatchSamples, reference: PatchSamples, channels: np.ndarray) -> np.ndarray:
    """Which directions (rows, columns) have a pattern. Raises MetricError where none has."""
    ours, theirs = candidate.values @ channels, reference.values @ channels
    if not np.abs(theirs).max() > 0 or not (found := _has_pattern(reference, channels)).any():
        raise MetricError("the patch shows no pattern; put a checker where the patch looks")
    if not np.ptp(ours) > 1e-6 * np.abs(ours).max():
        raise MetricError("the candidate shows no pattern on the patch; there is nothing to lay on the reference's")
    return found


def _has_pattern(samples: PatchSamples, channels: np.ndarray) -> np.ndarray:
    """For rows and columns: whether the picture has slopes that only a move along that axis explains.

    Gain and offset are fitted along with the move, so even shading places nothing; nor does an edge along its own
    direction. What noise alone may have made is no pattern.
    """
    picture = smooth(samples, channels)
    window = np.outer(np.hanning(picture.shape[0] + 2)[1:-1], np.hanning(picture.shape[1] + 2)[1:-1])
    weight = (window / window.sum()).ravel()
    slopes = _slopes(picture)
    whole = max(float((weight * slope.ravel() ** 2).sum()) for slope in slopes)
    mean, found = abs(float((weight * picture.ravel()).sum())), np.zeros(2, dtype=bool)
    for axis in (0, 1):
        others = np.stack([picture.ravel(), np.ones(picture.size), slopes[1 - axis].ravel()], axis=1)
        own = _unexplained(slopes[axis], others, weight)
        clear = own - _square_slope_of_noise(samples, channels, axis, others, weight)
        steepness = np.sqrt(max(clear, 0.0)) * picture.shape[axis]
        found[axis] = clear > LEAST_TEXTURE * whole and steepness > LEAST_STEEPNESS * mean
    return found


def _square_slope_of_noise(
    samples: PatchSamples, channels: np.ndarray, axis: int, others: np.ndarray, weight: np.ndarray
) -> float:
    """The most that noise alone gives to the mean square slope along an axis, within ``NOISE_SIGMAS``."""
    if samples.noise is None:
        return 0.0
    grain = gaussian_filter(samples.noise @ channels, SMOOTHING_CELLS)
    independent = max(1.0 / float((weight**2).sum()) / CELLS_ALIKE, 1.0)
    mean_square = _unexplained(_slopes(grain)[axis], others, weight)
    return float(mean_square * (1 + NOISE_SIGMAS * np.sqrt(2 / independent)))


def _slopes(picture: np.ndarray) -> list[np.ndarray]:
    """Light per cell along rows and columns; 0 along an axis of one cell."""
    return [np.gradient(picture, axis=axis) if picture.shape[axis] > 4 else np.zeros_like(picture) for axis in (0, 1)]


def _unexplained(slope: np.ndarray, others: np.ndarray, weight: np.ndarray) -> float:
    """Weighted mean square of ``slope`` less its best fit by the columns of ``others``."""
    root = np.sqrt(weight)
    fitted, *_ = np.linalg.lstsq(others * root[:, None], slope.ravel() * root, rcond=None)
    return float((weight * (slope.ravel() - others @ fitted) ** 2).sum())


def stands_out(samples: PatchSamples, axis: int, channels: np.ndarray) -> bool:
    """Whether the slopes of the smoothed pattern along an axis are several times those of its noise."""
    if samples.noise is None:
        return True
    grain = gaussian_filter(samples.noise @ channels, SMOOTHING_CELLS)
    whole, noise = (float(np.mean(np.diff(each, axis=axis) ** 2)) for each in (smooth(samples, channels), grain))
    return whole >= LEAST_OVER_NOISE * noise


def smooth(samples: PatchSamples, channels: np.ndarray) -> np.ndarray:
    smoothed: np.ndarray = gaussian_filter(samples.values @ channels, SMOOTHING_CELLS)
    return smoothed
