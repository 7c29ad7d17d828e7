"""How far glass or a mirror moves the picture of a pattern, by registration to a small part of a cell."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter, spline_filter
from scipy.ndimage import shift as spline_shift
from skimage.registration import phase_cross_correlation

from vitrail.images.patch import PatchSamples
from vitrail.metrics.edge import fit_edge
from vitrail.metrics.measurement import Context, Measurement, MetricError, PatchAxis, PatchMetric
from vitrail.metrics.pattern import SMOOTHING_CELLS, channel_weights, smooth, stands_out, usable_axes
from vitrail.metrics.profile import cell_m, profile

STEPS = 30
"""Gauss-Newton steps at most; it settles in about six."""

SETTLED_CELLS = 1e-6
"""A step this small is the last: noise moves no picture by so little."""

SLOPE_CELLS = 0.02
"""Half the move over which the slope of a shifted spline is taken: its third derivative does not show yet."""

LEAST_GAIN = 1e-9
"""Below it the candidate has nothing of the reference's pattern."""

AXES: tuple[tuple[PatchAxis, int], ...] = (("u", 1), ("v", 0))
"""Directions on the patch with their place among rows and columns."""


def displacement(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """``displacement.u/.v``: how far the candidate's picture lies from the reference's, metres on the patch, ideal 0.

    Brightness and offset are fitted along, so it sees neither exposure nor tint. Channels weigh as they are quiet: red
    grain of a few photons does not blur what green and blue show. Directions without a pattern are left out. Raises
    MetricError on a patch without any pattern. A comparison only; ``edge_place`` is the absolute quantity.
    """
    if reference is None:
        return []
    weights = channel_weights(candidate, reference)
    usable = usable_axes(candidate, reference, weights)
    moved = register(smooth(candidate, weights), smooth(reference, weights), usable).moved
    flat = [axis for axis, index in AXES if not usable[index]]
    caveats = tuple(f"along {axis} no pattern stands out, so no move along it is measured" for axis in flat)
    method = "least squares of a cubic-spline shift with gain and offset, started by phase correlation"
    settings = {"method": method, "smoothing_cells": SMOOTHING_CELLS}
    found = []
    for axis, index in AXES:
        if usable[index]:
            cell = cell_m(candidate, axis)
            parts = {"cells": float(moved[index]), "cell_m": cell}
            move = float(moved[index] * cell)
            found.append(Measurement(f"displacement.{axis}", move, "m", 0.0, settings, parts, caveats=caveats))
    return found


def displacement_near(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> PatchMetric:
    """``displacement`` of images that differ little from these: one registration, and how each cell moves its result.

    The registration is a least-squares fit, so a change of either picture by n moves it by a weighted sum of n. Those
    weights, carried back through the smoothing and the shift, make one product of every later registration. A direction
    whose pattern does not stand out of the noise has no such weights; then it is ``displacement`` itself.
    """
    if reference is None:
        return displacement
    channels = channel_weights(candidate, reference)
    usable = usable_axes(candidate, reference, channels)
    pairs = [(image, index) for image in (candidate, reference) for _, index in AXES if usable[index]]
    if not all(stands_out(image, index, channels) for image, index in pairs):
        return displacement
    found = register(smooth(candidate, channels), smooth(reference, channels), usable)
    weights = {axis: _influence(found, index) for axis, index in AXES if usable[index]}

    def again(ours: PatchSamples, theirs: PatchSamples | None, known: Context) -> list[Measurement]:
        assert theirs is not None
        change = [(new.values - old.values) @ channels for new, old in ((ours, candidate), (theirs, reference))]
        moves = {
            axis: found.moved[index] + sum(float((w * n).sum()) for w, n in zip(weights[axis], change, strict=True))
            for axis, index in AXES
            if axis in weights
        }
        return [Measurement(f"displacement.{axis}", move * cell_m(ours, axis), "m") for axis, move in moves.items()]

    return again


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


@dataclass(frozen=True)
class Registration:
    """``moved`` (rows, columns): how far the reference must be moved, in cells.

    ``gain``: how many times the reference's contrast the candidate has. ``influence`` (2, nv, nu): by how much each
    cell of the candidate moves the reference.
    """

    moved: np.ndarray
    gain: float
    influence: np.ndarray


def register(ours: np.ndarray, theirs: np.ndarray, usable: np.ndarray) -> Registration:
    """Lay ``theirs`` on ``ours`` by a move along the ``usable`` axes.

    Minimises the sum over the interior of (ours - gain * moved - offset)^2.
    """
    window = np.outer(np.hanning(ours.shape[0] + 2)[1:-1], np.hanning(ours.shape[1] + 2)[1:-1])
    start, _, _ = phase_cross_correlation(
        (ours - ours.mean()) * window, (theirs - theirs.mean()) * window, upsample_factor=10, normalization=None
    )
    moved = np.where(usable, start, 0.0)
    spline = spline_filter(theirs, order=3, mode="nearest")
    gain, influence = 0.0, np.zeros((2, *ours.shape))
    for _ in range(STEPS):
        step, gain, influence = _step(ours, spline, moved, usable, window)
        moved = moved + step
        if np.abs(step).max() < SETTLED_CELLS:
            break
    limit = np.array(ours.shape) / 2
    if not (np.isfinite(moved).all() and (np.abs(moved) < limit).all()):
        raise MetricError("the two patterns do not match anywhere; are they the same pattern?")
    return Registration(moved, gain, influence)


def _step(
    ours: np.ndarray, spline: np.ndarray, moved: np.ndarray, usable: np.ndarray, window: np.ndarray
) -> tuple[np.ndarray, float, np.ndarray]:
    """One Gauss-Newton step of the displacement, the gain, and the influence of each cell on the step.

    Gain and offset are solved for at the same time.
    """
    shifted = _shifted(spline, moved)
    # Differences of moves, not of cells: neighbouring cells are too far apart for the slope of an edge.
    moves = np.eye(2)[usable] * SLOPE_CELLS
    slopes = [(_shifted(spline, moved + move) - _shifted(spline, moved - move)) / (2 * SLOPE_CELLS) for move in moves]
    columns = np.stack([shifted, np.ones_like(shifted), *slopes])
    columns = columns.reshape(len(columns), -1)
    weighted = columns * window.ravel()
    normal = weighted @ columns.T
    # Columns of equal size keep the normal equations as good as the columns are.
    size = np.sqrt(np.maximum(np.diag(normal), np.finfo(float).tiny))
    solution = (np.linalg.pinv(normal / np.outer(size, size), rcond=1e-12) / size[:, None]) @ (weighted / size[:, None])
    gain, _, *scaled = solution @ ours.ravel()
    step, influence = np.zeros(2), np.zeros((2, *ours.shape))
    if abs(gain) >= LEAST_GAIN:
        # Two cells at most a step: beyond that the linear picture of the pattern does not hold.
        step[usable] = np.clip(np.array(scaled) / gain, -2, 2)
        influence[usable] = solution[2:].reshape(-1, *ours.shape) / gain
    return step, float(gain), influence


def _shifted(spline: np.ndarray, moved: np.ndarray) -> np.ndarray:
    shifted: np.ndarray = spline_shift(spline, moved, order=3, mode="nearest", prefilter=False)
    return shifted


def _influence(found: Registration, axis: int) -> tuple[np.ndarray, np.ndarray]:
    """By how much the move grows with each cell of the two pictures as they are, before smoothing and shift.

    The window leaves nothing at the borders, where smoothing and shift are not their own transposes.
    """
    own = gaussian_filter(found.influence[axis], SMOOTHING_CELLS)
    return own, -found.gain * spline_shift(own, -found.moved, order=3, mode="nearest")
