"""How evenly a patch is lit: signed, linear shapes, so that noise alone has no preferred sign."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Context, Measurement, MetricError


def evenness(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Tilt and bow of the mean of the channels over the patch, as shares of its mean radiance.

    ``tilt.u`` and ``tilt.v``: change from one edge to the other of the best plane. ``bow``: middle minus border of the
    best parabola, summed over both directions. Absolute, or as ``tilt_shift`` and ``bow_shift`` against a reference,
    ideal 0. Raises MetricError on a black patch.
    """
    ours = _shape(candidate)
    names = ("tilt.u", "tilt.v", "bow")
    if reference is None:
        return [Measurement(name, x, "1", None) for name, x in zip(names, ours, strict=True)]
    shift_names = ("tilt_shift.u", "tilt_shift.v", "bow_shift")
    pairs = zip(shift_names, ours, _shape(reference), strict=True)
    return [Measurement(n, x - y, "1", 0.0, parts={"candidate": x, "reference": y}) for n, x, y in pairs]


def _shape(samples: PatchSamples) -> tuple[float, float, float]:
    """Least squares of 1, s, t, s^2 + t^2 (s and t run from -1 to 1 across the patch), relative to the mean."""
    grey = samples.values.mean(axis=-1)
    s = samples.u_m / (np.abs(samples.u_m).max() + samples.cell_u_m / 2)
    t = samples.v_m / (np.abs(samples.v_m).max() + samples.cell_v_m / 2)
    tt, ss = np.meshgrid(t, s, indexing="ij")
    columns = np.stack([np.ones_like(ss), ss, tt, ss**2 + tt**2], axis=-1)[samples.coverage > 0.5]
    values = grey[samples.coverage > 0.5]
    if values.size == 0 or not values.mean() > 0:
        raise MetricError("the patch is black or outside the image; it has no evenness")
    # Row and column patches of one cell leave columns undetermined; least squares then takes the smallest, 0.
    fit = np.linalg.lstsq(columns, values, rcond=1e-9)[0] / values.mean()
    return float(2 * fit[1]), float(2 * fit[2]), float(-2 * fit[3])
