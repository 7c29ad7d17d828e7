"""How far glass or a mirror moves the picture of a pattern, by registration to a small part of a cell."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter
from scipy.ndimage import shift as spline_shift
from skimage.registration import phase_cross_correlation

from vitrail.images.patch import PatchSamples
from vitrail.metrics.edge import fit_edge
from vitrail.metrics.measurement import Context, Measurement, MetricError, PatchAxis
from vitrail.metrics.profile import cell_m, profile

SMOOTHING_CELLS = 1.0
"""Both pictures are blurred this much first: a sharp edge in cells is not band-limited, and a spline cannot move it."""

STEPS = 30
"""Gauss-Newton steps at most; it settles in about six."""

LEAST_TEXTURE = 1e-3
"""A direction with less than this share of the other's gradient has no pattern to register."""


def displacement(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """``displacement.u/.v``: how far the candidate's picture lies from the reference's, metres on the patch, ideal 0.

    Brightness and offset are fitted along, so it sees neither exposure nor tint. Directions without a pattern are left
    out. Raises MetricError on a patch without any pattern. A comparison only; ``edge_place`` is the absolute quantity.
    """
    if reference is None:
        return []
    ours, theirs = candidate.values.mean(axis=-1), reference.values.mean(axis=-1)
    texture = np.array([np.mean(np.diff(theirs, axis=axis) ** 2) if theirs.shape[axis] > 4 else 0.0 for axis in (0, 1)])
    if not texture.max() > (1e-6 * np.abs(theirs).max()) ** 2:
        raise MetricError("the patch shows no pattern; put a checker where the patch looks")
    if not np.ptp(ours) > 1e-6 * np.abs(ours).max():
        raise MetricError("the candidate shows no pattern on the patch; there is nothing to lay on the reference's")
    usable = texture > LEAST_TEXTURE * texture.max()
    moved = register(gaussian_filter(ours, SMOOTHING_CELLS), gaussian_filter(theirs, SMOOTHING_CELLS), usable)
    method = "least squares of a cubic-spline shift with gain and offset, started by phase correlation"
    settings = {"method": method, "smoothing_cells": SMOOTHING_CELLS}
    found = []
    axes: tuple[tuple[PatchAxis, int], ...] = (("u", 1), ("v", 0))
    for axis, index in axes:
        if usable[index]:
            cell = cell_m(candidate, axis)
            parts = {"cells": float(moved[index]), "cell_m": cell}
            found.append(Measurement(f"displacement.{axis}", float(moved[index] * cell), "m", 0.0, settings, parts))
    return found


def edge_place(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Absolute: ``edge_place.<along>``, metres from the patch centre, of the edge nearest to the centre.

    A patch without an edge, or a comparison, gives nothing: ``displacement`` uses the whole pattern.
    """
    if reference is not None:
        return []
    x, channels = profile(candidate.values, candidate, context.along)
    try:
        edge = fit_edge(x, channels.mean(axis=-1), cell_m(candidate, context.along))
    except MetricError:
        return []
    parts = {"sigma_m": edge.sigma_m, "before": edge.before, "after": edge.after}
    return [Measurement(f"edge_place.{context.along}", edge.position_m, "m", None, parts=parts)]


def register(ours: np.ndarray, theirs: np.ndarray, usable: np.ndarray) -> np.ndarray:
    """(rows, columns) by which ``theirs`` must be moved to lie on ``ours``, in cells, along the ``usable`` axes.

    Minimises the sum over the interior of (ours - gain * moved - offset)^2.
    """
    window = np.outer(np.hanning(ours.shape[0] + 2)[1:-1], np.hanning(ours.shape[1] + 2)[1:-1])
    start, _, _ = phase_cross_correlation(
        (ours - ours.mean()) * window, (theirs - theirs.mean()) * window, upsample_factor=10, normalization=None
    )
    moved = np.where(usable, start, 0.0)
    for _ in range(STEPS):
        step = _step(ours, theirs, moved, usable, window)
        moved = moved + step
        if np.abs(step).max() < 1e-7:
            break
    limit = np.array(ours.shape) / 2
    if not (np.isfinite(moved).all() and (np.abs(moved) < limit).all()):
        raise MetricError("the two patterns do not match anywhere; are they the same pattern?")
    return moved


def _step(
    ours: np.ndarray, theirs: np.ndarray, moved: np.ndarray, usable: np.ndarray, window: np.ndarray
) -> np.ndarray:
    """One Gauss-Newton step of the displacement; gain and offset are solved for at the same time."""
    shifted = spline_shift(theirs, moved, order=3, mode="nearest")
    weight = np.sqrt(window).ravel()
    slopes = [np.gradient(shifted, axis=axis).ravel() if usable[axis] else np.zeros(ours.size) for axis in (0, 1)]
    columns = np.stack([shifted.ravel(), np.ones(ours.size), -slopes[0], -slopes[1]], axis=-1) * weight[:, None]
    gain, _, *scaled = np.linalg.lstsq(columns, ours.ravel() * weight, rcond=1e-12)[0]
    if abs(gain) < 1e-9:
        return np.zeros(2)
    # Two cells at most a step: beyond that the linear picture of the pattern does not hold.
    return np.clip(np.where(usable, np.array(scaled) / gain, 0.0), -2, 2)
