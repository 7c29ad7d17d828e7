"""What the noise of a patch comes from: photons, edges between samples, or rays that are drawn at random.

Each cause is strong in other places. The variance of a photon estimate is proportional to the light that photons
brought. A sample beside an edge, also that of a caustic, sees one side or the other, so its variance is at most what
the gradient of the light allows. Rays of rough glass and of lamps are drawn anew everywhere: their variance follows the
square of the light that no photon brought. What the halves differ by is fitted by these three, none below zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.optimize import lsq_linear

PHOTON_LAYER = "caustic"
"""The layer whose light photons brought."""

SHARPEST = 0.5
"""Variance of one sample over the squared gradient, at most: a step h varies by h^2/4 in its cell, and its gradient is
h/2 in two cells. Light without edges thus gives samples next to no noise."""


@dataclass(frozen=True)
class NoiseCauses:
    """Mean variance of a cell by cause, (W sr^-1 m^-2)^2."""

    photons: float
    edges: float
    rays: float


def noise_causes(
    noise: np.ndarray, light: np.ndarray, layers: Mapping[str, np.ndarray], *, draws_rays: bool = True
) -> NoiseCauses:
    """The causes of ``noise``, one realisation (nv, nu, 3), in ``light`` of the same shape.

    ``layers`` split that light, as the tracer knows it; without the layer of photons none of it is theirs.
    ``draws_rays`` says whether anything in the scene is seen by rays that are drawn at random.
    """
    photons = np.abs(layers.get(PHOTON_LAYER, np.zeros_like(light))).mean(axis=-1)
    rest = np.maximum(light.mean(axis=-1) - photons, 0.0)
    whole = light.mean(axis=-1)
    slopes = [np.gradient(whole, axis=axis) if whole.shape[axis] > 1 else np.zeros_like(whole) for axis in (0, 1)]
    fields = [photons, slopes[0] ** 2 + slopes[1] ** 2, rest**2]
    # Bring the fields to one size, because the fit weighs what it is given; an endless bound is none.
    sizes = np.array([float(field.mean()) for field in fields])
    most = np.array([np.inf, SHARPEST * sizes[1], np.inf if draws_rays else 0.0])
    used = np.flatnonzero((sizes > 0) & (most > 0))
    variance = (noise**2).mean(axis=-1)
    if used.size == 0 or not variance.any():
        return NoiseCauses(0.0, 0.0, 0.0)
    columns = np.stack([fields[index].ravel() / sizes[index] for index in used], axis=-1)
    scale = float(variance.mean())
    found = lsq_linear(columns, variance.ravel() / scale, bounds=(0.0, most[used] / scale)).x * scale
    causes = np.zeros(3)
    causes[used] = np.maximum(found, 0.0)
    return NoiseCauses(*(float(each) for each in causes))
