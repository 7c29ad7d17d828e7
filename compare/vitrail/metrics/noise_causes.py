"""What the noise of a patch comes from: photons, edges between samples, or rays that are drawn at random.

Each cause is strong in other places. The variance of a photon estimate is proportional to the light that photons
brought. A sample beside an edge or on a peak, also that of a caustic, sees one side or the other, so its variance is at
most what the light around it varies by. Rays of rough glass and of lamps are drawn anew everywhere: their variance
follows the square of the light that no photon brought. What the halves differ by is fitted by these three, none below
zero, as the likeliest: a dark cell tells as much as a bright one, or a few bright cells alone would decide.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import uniform_filter
from scipy.optimize import lsq_linear

SHARPEST = 1.0
"""Variance of a cell over that of the light around it, at most. A step h beside a cell varies by 2/9 h^2 there, and one
sample of it by h^2/4; a peak that one of n samples meets has n times its mean, and each of nine cells knows of it."""

AROUND = 3
"""Cells along the edge of what is around a cell: finer structures than cells show in their neighbours alone."""

ROUNDS = 12
"""Times the fit is weighed anew; the shares then change by less than a hundredth."""

QUIETEST = 1e-3
"""Of the mean variance, what a cell has at least when fits are weighed: none is without any noise."""


@dataclass(frozen=True)
class NoiseCauses:
    """Mean variance of a cell by cause, (W sr^-1 m^-2)^2.

    That of ``photons`` is already as many times larger as cells share one gather disc: a sum over a patch has fewer
    discs than cells, and its variance is compared with that of causes that strike every cell for itself.
    """

    photons: float
    edges: float
    rays: float


def noise_causes(
    noise: np.ndarray, light: np.ndarray, photons: np.ndarray, drawn: np.ndarray, *, disc_cells: float = 1.0
) -> NoiseCauses:
    """The causes of ``noise``, one realisation (nv, nu, 3), in ``light`` of the same shape.

    Of that light ``photons`` were brought by photons, and ``drawn`` is seen by rays that are drawn at random.
    ``disc_cells`` is how many cells a gather disc covers.
    """
    brought, seen = (np.abs(each).mean(axis=-1) for each in (photons, drawn))
    fields = np.stack([brought, _variation(light.mean(axis=-1), noise.mean(axis=-1)), seen**2])
    variance = (noise**2).mean(axis=-1)
    # Bring the fields to one size, because the fit weighs what it is given; an endless bound is none.
    sizes = fields.mean(axis=(1, 2))
    most = np.array([np.inf, SHARPEST * sizes[1], np.inf])
    used = np.flatnonzero(sizes > 0)
    scale = float(variance.mean())
    if used.size == 0 or scale == 0:
        return NoiseCauses(0.0, 0.0, 0.0)
    columns = (fields[used] / sizes[used, None, None]).reshape(used.size, -1).T
    causes = np.zeros(3)
    causes[used] = scale * _likeliest(columns, variance.ravel() / scale, most[used] / scale)
    return NoiseCauses(float(causes[0]) * max(disc_cells, 1.0), float(causes[1]), float(causes[2]))


def _variation(light: np.ndarray, noise: np.ndarray) -> np.ndarray:
    """Variance of the light around each cell, without that of its noise: the covariance of the two halves."""
    return np.maximum(_variance_around(light) - _variance_around(noise), 0.0)


def _variance_around(values: np.ndarray) -> np.ndarray:
    middle = values - values.mean()
    mean = uniform_filter(middle, AROUND, mode="nearest")
    found: np.ndarray = uniform_filter(middle**2, AROUND, mode="nearest") - mean**2
    return np.maximum(found, 0.0)


def _likeliest(columns: np.ndarray, variance: np.ndarray, most: np.ndarray) -> np.ndarray:
    """What each column brings, from 0 to ``most``: squares of normal noise vary by their own mean, and weigh so."""
    weight = np.ones_like(variance)
    found = np.zeros(columns.shape[1])
    for _ in range(ROUNDS):
        found = lsq_linear(columns * weight[:, None], variance * weight, bounds=(0.0, most)).x
        weight = 1 / np.maximum(columns @ found, QUIETEST)
    # The likeliest shares need not add up to the noise that is there; what is bought lessens all of it.
    whole = found.sum()
    return np.maximum(found, 0.0) / whole if whole > 0 else found
