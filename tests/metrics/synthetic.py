"""Patches with known light on them: what every metric is tested against."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples

FINE = 8
"""Points along a cell that it is the mean of, so that moving a picture by a part of a cell changes it rightly."""


def patch_of(light, *, half_u=1.0, half_v=1.0, n_u=64, n_v=64, layers=None) -> PatchSamples:
    """Samples of ``light(u, v) -> (..., 3) or (...)``, each cell the mean over itself; no halves."""
    u = (np.arange(n_u) + 0.5) * 2 * half_u / n_u - half_u
    v = (np.arange(n_v) + 0.5) * 2 * half_v / n_v - half_v
    area = 4 * half_u * half_v / (n_u * n_v)
    values = averaged(light, half_u, half_v, n_u, n_v)
    extra = {name: averaged(layer, half_u, half_v, n_u, n_v) for name, layer in (layers or {}).items()}
    return PatchSamples(values, None, None, u, v, area, np.ones((n_v, n_u)), extra)


def averaged(light, half_u, half_v, n_u, n_v) -> np.ndarray:
    fine_u = (np.arange(n_u * FINE) + 0.5) * 2 * half_u / (n_u * FINE) - half_u
    fine_v = (np.arange(n_v * FINE) + 0.5) * 2 * half_v / (n_v * FINE) - half_v
    values = np.asarray(light(fine_u[None, :], fine_v[:, None]), float)
    if values.ndim == 2:
        values = np.repeat(np.broadcast_to(values, (fine_v.size, fine_u.size))[..., None], 3, axis=-1)
    values = np.broadcast_to(values, (fine_v.size, fine_u.size, 3))
    return values.reshape(n_v, FINE, n_u, FINE, 3).mean(axis=(1, 3))


def noisy(samples: PatchSamples, sigma, seed: int) -> PatchSamples:
    """The same patch rendered with noise: two halves of standard deviation ``sigma`` * sqrt(2) and their mean.

    ``sigma`` is a number or a field (nv, nu, 1): that of the mean.
    """
    draw = np.random.default_rng(seed)
    a, b = (samples.values + draw.normal(size=samples.values.shape) * sigma * np.sqrt(2) for _ in range(2))
    return PatchSamples(
        (a + b) / 2, a, b, samples.u_m, samples.v_m, samples.cell_area_m2, samples.coverage, samples.layers
    )


def spot(u0=0.0, v0=0.0, sigma=0.15, power=1.0, colour=(1.0, 1.0, 1.0)):
    """A Gaussian caustic that holds ``power`` W/sr in each channel of colour 1."""

    def light(u, v):
        shape = np.exp(-((u - u0) ** 2 + (v - v0) ** 2) / (2 * sigma**2)) / (2 * np.pi * sigma**2)
        return power * shape[..., None] * np.array(colour)

    return light


def value_of(measurements, name: str) -> float:
    return next(m.value for m in measurements if m.metric == name)
