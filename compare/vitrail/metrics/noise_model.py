"""The law of an image's noise, learnt from one realisation of it: variance by place, correlation, colour.

The variance is taken as proportional to radiance, as that of counted photons is, with a factor that changes slowly over
the patch; the factor is the local mean of noise squared over the local mean of radiance, so any other law is followed
at the same slow pace. The correlation (photons gathered within a disc) is taken as the same everywhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np
from scipy import fft
from scipy.ndimage import gaussian_filter

from vitrail.images.patch import PatchSamples

SMOOTHING = 3.0
"""Correlation lengths that make one standard deviation of the window over which the factor is averaged."""

LEAST_SMOOTHING_CELLS = 3.0

LEAST_LAG_CELLS = 2
"""Neighbouring cells share pixels, whatever the renderer did."""

DISC_REACH = 2.0
"""Two gather discs overlap up to two radii apart."""

DARKEST = 1e-3
"""Share of the mean radiance that the darkest cells count as: noise does not end where light does."""


@dataclass(frozen=True)
class NoiseModel:
    """``deviation`` (nv, nu, 3); ``spectrum`` of unit noise on a padded grid; ``mixing`` (3, 3) of the channels."""

    deviation: np.ndarray
    spectrum: np.ndarray
    mixing: np.ndarray

    @property
    def is_loud(self) -> bool:
        return bool(np.any(self.deviation > 0))

    def pair(self, seed: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
        """Two independent fields of noise (nv, nu, 3) of this law; a pure function of ``seed``."""
        rows, columns = self.deviation.shape[:2]
        shape = self.spectrum.shape
        # Complex white noise is its own transform; through the root of the spectrum it has the measured correlation,
        # and its two parts know nothing of each other.
        white = np.random.default_rng(seed).standard_normal((3, *shape, 2), dtype=np.float32).view(np.complex64)[..., 0]
        size = np.float32(np.sqrt(self.spectrum.size))
        shaped = fft.ifft2(white * (np.sqrt(self.spectrum).astype(np.float32) * size))[:, :rows, :columns]
        parts = (np.moveaxis(part, 0, -1) @ self.mixing.T for part in (shaped.real, shaped.imag))
        first, second = (self.deviation * part for part in parts)
        return first, second

    def draws(self, count: int, seed: int) -> Iterator[np.ndarray]:
        """The first ``count`` fields of the sequence that belongs to ``seed``."""
        pairs = (field for number in range((count + 1) // 2) for field in self.pair((number, seed)))
        return islice(pairs, count)


def learn_noise(samples: PatchSamples, correlation_m: float) -> NoiseModel | None:
    """The law of the noise of ``samples``, or None where no halves are known.

    ``correlation_m`` is the length over which the renderer itself made noise alike (the gather radius).
    """
    noise = samples.noise
    if noise is None:
        return None
    known = (correlation_m / samples.cell_v_m, correlation_m / samples.cell_u_m)
    lengths = [max(known[axis], _correlation_cells(noise, axis)) for axis in (0, 1)]
    deviation = np.sqrt(_variance(samples.values, noise, lengths))
    unit = np.divide(noise, deviation, out=np.zeros_like(noise), where=deviation > 0)
    reach = [int(np.ceil(max(LEAST_LAG_CELLS, DISC_REACH * length))) for length in lengths]
    return NoiseModel(deviation, _spectrum(unit, deviation > 0, reach), _mixing(unit))


def _variance(values: np.ndarray, noise: np.ndarray, lengths: list[float]) -> np.ndarray:
    width = (*(max(LEAST_SMOOTHING_CELLS, SMOOTHING * length) for length in lengths), 0)
    light = np.maximum(np.abs(values), DARKEST * np.abs(values).mean(axis=(0, 1)))
    around = gaussian_filter(light, width, mode="reflect")
    factor = np.divide(
        gaussian_filter(noise**2, width, mode="reflect"), around, out=np.zeros_like(light), where=around > 0
    )
    return light * factor


def _spectrum(unit: np.ndarray, loud: np.ndarray, reach: list[int]) -> np.ndarray:
    """Power spectrum of the unit noise on a grid with room for ``reach``, from its autocorrelation within ``reach``."""
    shape = [fft.next_fast_len(size + 2 * far + 1) for size, far in zip(unit.shape[:2], reach, strict=True)]
    axes = (0, 1)
    power = np.abs(fft.fft2(unit, s=shape, axes=axes)) ** 2
    pairs = np.abs(fft.fft2(loud.astype(float), s=shape, axes=axes)) ** 2
    products, counts = (fft.ifft2(each.sum(axis=-1)).real for each in (power, pairs))
    alike = np.where(counts > 0.5, products / np.maximum(counts, 1.0), 0.0)
    # Beyond the reach there is nothing but the scatter of the estimate.
    lag_v, lag_u = (np.abs(fft.fftfreq(size, 1 / size)) for size in shape)
    near = (lag_v / (reach[0] + 0.5))[:, None] ** 2 + (lag_u / (reach[1] + 0.5))[None, :] ** 2 <= 2
    spectrum = np.maximum(fft.fft2(np.where(near, alike, 0.0)).real, 0.0)
    mean = spectrum.mean()
    return spectrum / mean if mean > 0 else np.ones(shape)


def _mixing(unit: np.ndarray) -> np.ndarray:
    """A root of the correlation of the channels: grey noise is one draw, coloured noise three."""
    flat = unit.reshape(-1, 3)
    size = np.sqrt((flat**2).mean(axis=0))
    # A channel without noise has no correlation; its deviation is 0 whatever is drawn for it.
    alike = flat.T @ flat / len(flat) / np.outer(size, size) if size.all() else np.eye(3)
    values, vectors = np.linalg.eigh(alike)
    return vectors * np.sqrt(np.maximum(values, 0.0))


def _correlation_cells(noise: np.ndarray, axis: int) -> float:
    """The length, in cells, over which noise stays alike: one-sided sum of its correlation until that is lost."""
    power = float((noise**2).mean())
    if power == 0:
        return 1.0
    moved, total = np.moveaxis(noise, axis, 0), 0.0
    for lag in range(1, max(2, moved.shape[0] // 4)):
        alike = float((moved[lag:] * moved[:-lag]).mean()) / power if moved.shape[0] > lag else 0.0
        # Below the scatter of the estimate itself there is nothing left to add.
        if alike < max(0.05, 2 / np.sqrt(noise.size)):
            break
        total += alike
    return 1.0 + total
