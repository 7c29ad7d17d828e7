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
from vitrail.metrics.profile import cell_m, profile

SMOOTHING_CELLS = 1.0
"""Both pictures are blurred this much first: a sharp edge in cells is not band-limited, and a spline cannot move it."""

STEPS = 30
"""Gauss-Newton steps at most; it settles in about six."""

SETTLED_CELLS = 1e-6
"""A step this small is the last: noise moves no picture by so little."""

SLOPE_CELLS = 0.02
"""Half the move over which the slope of a shifted spline is taken: its third derivative does not show yet."""

LEAST_GAIN = 1e-9
"""Below it the candidate has nothing of the reference's pattern."""

LEAST_OVER_NOISE = 10.0
"""Square slopes of pattern and noise over those of the noise: the fit is then linear in the noise to some percent."""

AXES: tuple[tuple[PatchAxis, int], ...] = (("u", 1), ("v", 0))
"""Directions on the patch with their place among rows and columns."""

LEAST_TEXTURE = 1e-3
"""A direction with less than this share of the other's gradient has no pattern to register."""

LEAST_STEEPNESS = 0.2
"""Least slope of a pattern, in its mean light per patch: below it the rounding of half floats, .05 % of the light,
reads as a move of .25 % of the patch, which is the size of the tolerance."""

NOISE_SIGMAS = 3.0
"""A pattern is there where the square slopes exceed those of the noise by this many standard deviations of theirs."""

CELLS_ALIKE = 4 * np.pi * SMOOTHING_CELLS**2
"""Cells over which the smoothing makes noise alike: the integral of a Gaussian's square correlation, twice."""


def displacement(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """``displacement.u/.v``: how far the candidate's picture lies from the reference's, metres on the patch, ideal 0.

    Brightness and offset are fitted along, so it sees neither exposure nor tint. Directions without a pattern are left
    out. Raises MetricError on a patch without any pattern. A comparison only; ``edge_place`` is the absolute quantity.
    """
    if reference is None:
        return []
    usable = _usable(candidate, reference)
    moved = register(_smooth(candidate), _smooth(reference), usable).moved
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
    usable = _usable(candidate, reference)
    if not all(_stands_out(image, index) for image in (candidate, reference) for _, index in AXES if usable[index]):
        return displacement
    found = register(_smooth(candidate), _smooth(reference), usable)
    weights = {axis: _influence(found, index) for axis, index in AXES if usable[index]}

    def again(ours: PatchSamples, theirs: PatchSamples | None, known: Context) -> list[Measurement]:
        assert theirs is not None
        change = [(new.values - old.values).mean(axis=-1) for new, old in ((ours, candidate), (theirs, reference))]
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


def _usable(candidate: PatchSamples, reference: PatchSamples) -> np.ndarray:
    """Which directions (rows, columns) have a pattern. Raises MetricError where none has."""
    ours, theirs = candidate.values.mean(axis=-1), reference.values.mean(axis=-1)
    if not np.abs(theirs).max() > 0 or not (found := _has_pattern(reference)).any():
        raise MetricError("the patch shows no pattern; put a checker where the patch looks")
    if not np.ptp(ours) > 1e-6 * np.abs(ours).max():
        raise MetricError("the candidate shows no pattern on the patch; there is nothing to lay on the reference's")
    return found


def _has_pattern(samples: PatchSamples) -> np.ndarray:
    """For rows and columns: whether the picture has slopes that only a move along that axis explains.

    Gain and offset are fitted along with the move, so even shading places nothing; nor does an edge along its own
    direction. What noise alone may have made is no pattern.
    """
    smooth = _smooth(samples)
    window = np.outer(np.hanning(smooth.shape[0] + 2)[1:-1], np.hanning(smooth.shape[1] + 2)[1:-1])
    weight = (window / window.sum()).ravel()
    slopes = _slopes(smooth)
    whole = max(float((weight * slope.ravel() ** 2).sum()) for slope in slopes)
    mean, found = abs(float((weight * smooth.ravel()).sum())), np.zeros(2, dtype=bool)
    for axis in (0, 1):
        others = np.stack([smooth.ravel(), np.ones(smooth.size), slopes[1 - axis].ravel()], axis=1)
        own = _unexplained(slopes[axis], others, weight)
        clear = own - _square_slope_of_noise(samples, axis, others, weight)
        steepness = np.sqrt(max(clear, 0.0)) * smooth.shape[axis]
        found[axis] = clear > LEAST_TEXTURE * whole and steepness > LEAST_STEEPNESS * mean
    return found


def _square_slope_of_noise(samples: PatchSamples, axis: int, others: np.ndarray, weight: np.ndarray) -> float:
    """The most that noise alone gives to the mean square slope along an axis, within ``NOISE_SIGMAS``."""
    if samples.noise is None:
        return 0.0
    grain = gaussian_filter(samples.noise.mean(axis=-1), SMOOTHING_CELLS)
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


def _stands_out(samples: PatchSamples, axis: int) -> bool:
    """Whether the slopes of the smoothed pattern along an axis are several times those of its noise."""
    if samples.noise is None:
        return True
    grain = gaussian_filter(samples.noise.mean(axis=-1), SMOOTHING_CELLS)
    whole, noise = (float(np.mean(np.diff(each, axis=axis) ** 2)) for each in (_smooth(samples), grain))
    return whole >= LEAST_OVER_NOISE * noise


def _smooth(samples: PatchSamples) -> np.ndarray:
    smooth: np.ndarray = gaussian_filter(samples.values.mean(axis=-1), SMOOTHING_CELLS)
    return smooth


def _influence(found: Registration, axis: int) -> tuple[np.ndarray, np.ndarray]:
    """By how much the move grows with each cell of the two pictures as they are, before smoothing and shift.

    The window leaves nothing at the borders, where smoothing and shift are not their own transposes.
    """
    own = gaussian_filter(found.influence[axis], SMOOTHING_CELLS)
    return own, -found.gain * spline_shift(own, -found.moved, order=3, mode="nearest")
