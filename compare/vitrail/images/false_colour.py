"""Signed and unsigned differences as pictures whose colours have a stated scale."""

from __future__ import annotations

import numpy as np

COLD = np.array([0.02, 0.25, 0.75])
NEUTRAL = np.array([0.95, 0.95, 0.95])
HOT = np.array([0.80, 0.10, 0.05])

HEAT = np.array(
    [
        [0.001, 0.000, 0.014],
        [0.258, 0.039, 0.406],
        [0.578, 0.148, 0.404],
        [0.865, 0.317, 0.226],
        [0.988, 0.645, 0.040],
        [0.988, 0.998, 0.645],
    ]
)
"""Six stations of the perceptually even `inferno` map; values between are linear."""


def signed_difference(candidate: np.ndarray, reference: np.ndarray, *, scale: float) -> np.ndarray:
    """(height, width, 3) picture in 0..1 of mean-channel ``candidate - reference``.

    Blue where the candidate is darker by ``scale`` (W sr^-1 m^-2) or more, red where it is brighter, light grey at 0.
    """
    if not scale > 0:
        raise ValueError(f"scale is {scale}; the radiance difference shown as full colour must be above 0")
    share = np.clip((candidate - reference).mean(axis=-1) / scale, -1, 1)[..., None]
    return np.where(share < 0, NEUTRAL + (COLD - NEUTRAL) * -share, NEUTRAL + (HOT - NEUTRAL) * share)


def heat(values: np.ndarray, *, low: float, high: float) -> np.ndarray:
    """(height, width, 3) picture in 0..1 of a scalar field; ``low`` is black, ``high`` pale yellow."""
    if not high > low:
        raise ValueError(f"the scale runs from {low} to {high}; it must go upwards")
    position = np.clip((np.asarray(values, float) - low) / (high - low), 0, 1) * (len(HEAT) - 1)
    station = np.arange(len(HEAT))
    return np.stack([np.interp(position, station, HEAT[:, channel]) for channel in range(3)], axis=-1)
