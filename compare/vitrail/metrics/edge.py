"""One edge in a profile: where it is, how wide it is, and what is to either side."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d
from scipy.optimize import least_squares
from scipy.special import ndtr

from vitrail.metrics.measurement import MetricError

LEAST_CONTRAST = 1e-3
"""An edge steps by at least this share of the profile's largest value; anything less is a gradient or noise."""

PLATEAU_SHARE = 0.15
"""The share of a profile at each end that is taken as plateau where the shape of the edge is not known."""

STEEP, CALM = 0.25, 0.1
"""Of the steepest slope: what an edge has somewhere, and what it has everywhere. Noise on a flank that passes one limit
twice would make two edges of one."""

LOUD = 6.0
"""Standard deviations of the slopes of noise that make no edge, because a wrong one would cut the right one short."""

WIDEST = 1 / 8
"""Of a profile, what is smoothed at most to see an edge in its noise."""


@dataclass(frozen=True)
class Edge:
    """An edge blurred by a Gaussian; ``sigma_m`` is 0 for a sharp one, ``before`` is at smaller positions.

    ``from_m`` and ``to_m`` are the ends of the part of the profile that it was fitted to.
    """

    position_m: float
    sigma_m: float
    before: float
    after: float
    from_m: float
    to_m: float


def fit_edge(
    x_m: np.ndarray, values: np.ndarray, cell_m: float, near_m: float = 0.0, *, noise: np.ndarray | None = None
) -> Edge:
    """The edge nearest to ``near_m``, by least squares of a blurred step averaged over each cell.

    Cells are averages, and the model is averaged alike, so a sharp edge between two cell centres is found where it is
    and with sigma 0. A periodic pattern is cut half-way to the neighbouring edges. ``noise`` is one realisation of what
    makes edges that are none. Raises MetricError without an edge.
    """
    window = _one_edge(x_m, values, near_m, noise)
    x, y = x_m[window], values[window]
    low, high = float(y[0]), float(y[-1])
    # Start where the step is steepest, and with a blur that has the height and the slope of the data.
    slope = np.gradient(y, x)
    steepest = int(np.argmax(np.abs(slope)))
    sigma = abs(high - low) / (abs(slope[steepest]) * np.sqrt(2 * np.pi))
    reach = x[-1] - x[0]

    def misfit(parameters: np.ndarray) -> np.ndarray:
        position, width, before, after = parameters
        return before + (after - before) * _blurred_step(x - position, abs(width), cell_m)[0] - y

    def slopes(parameters: np.ndarray) -> np.ndarray:
        position, width, before, after = parameters
        step, by_place, by_width = _blurred_step(x - position, abs(width), cell_m)
        height = after - before
        return np.stack([-height * by_place, height * np.sign(width) * by_width, 1 - step, step], axis=-1)

    start = np.array([x[steepest], max(sigma, 0.3 * cell_m), low, high])
    scale = np.array([reach, reach, abs(high - low), abs(high - low)])
    found = least_squares(misfit, start, slopes, method="lm", x_scale=scale, xtol=1e-12, ftol=1e-12, gtol=1e-12).x
    return Edge(float(found[0]), float(abs(found[1])), float(found[2]), float(found[3]), float(x[0]), float(x[-1]))


def _blurred_step(x: np.ndarray, sigma: float, cell: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The mean over a cell of the normal distribution function of width ``sigma``; a clipped ramp for sigma -> 0.

    With its slopes by place and by width.
    """
    sigma = max(sigma, 1e-6 * cell)
    ends = np.stack([x - cell / 2, x + cell / 2]) / sigma
    share, height = ndtr(ends), np.exp(-(ends**2) / 2) / np.sqrt(2 * np.pi)
    integral = sigma * (ends * share + height)
    # The integral over t of the step is sigma (z Phi + phi) with z = t / sigma: by t it grows by Phi, by sigma by phi.
    mean, by_place, by_width = ((each[1] - each[0]) / cell for each in (integral, share, height))
    return mean, by_place, by_width


def _one_edge(x_m: np.ndarray, values: np.ndarray, near_m: float, noise: np.ndarray | None) -> slice:
    """The part of the profile that holds one edge only: between the middles of the plateaus to either side of it."""
    slope = _slope(values, noise)
    # Edges are the runs of slope of one sign that are steep somewhere; take the one nearest to where it was asked for.
    most = np.abs(slope).max()
    signs = np.where(np.abs(slope) > CALM * most, np.sign(slope), 0)
    ends = np.flatnonzero(np.diff(signs, prepend=0, append=0))
    runs = [
        (start, stop - 1)
        for start, stop in itertools.pairwise(ends)
        if signs[start] != 0 and np.abs(slope[start:stop]).max() > STEEP * most
    ]
    middles = np.array([x_m[a : b + 1].mean() for a, b in runs])
    chosen = int(np.argmin(np.abs(middles - near_m)))
    # A plateau ends half-way to the next run; at the ends of the profile it goes on to the end.
    left = 0 if chosen == 0 else (runs[chosen - 1][1] + runs[chosen][0] + 1) // 2
    right = values.size if chosen == len(runs) - 1 else (runs[chosen][1] + runs[chosen + 1][0] + 1) // 2
    return slice(int(left), int(right)) if right - left >= 5 else slice(0, values.size)


def _slope(values: np.ndarray, noise: np.ndarray | None) -> np.ndarray:
    """The slope of a profile, smoothed over a cell, or over so many that noise makes no edge. Raises MetricError."""
    width = 1.0
    while values.size >= 5 and width <= max(1.0, WIDEST * values.size):
        smooth = gaussian_filter1d(values, width, mode="nearest")
        slope: np.ndarray = np.gradient(smooth)
        if not float(np.ptp(smooth)) > LEAST_CONTRAST * float(np.abs(values).max()):
            break
        grain = 0.0 if noise is None else np.gradient(gaussian_filter1d(noise, width, mode="nearest")).std()
        if LOUD * grain <= STEEP * np.abs(slope).max():
            return slope
        width *= 2
    raise MetricError("no edge in the profile stands out of its noise; put the patch across an edge of the pattern")


@dataclass(frozen=True)
class Ramp:
    """An edge of any shape between two plateaus: where it crosses 10, 50 and 90 % of the step."""

    x10_m: float
    x50_m: float
    x90_m: float
    before: float
    after: float

    @property
    def width_m(self) -> float:
        """From 10 % to 90 % of the step."""
        return abs(self.x90_m - self.x10_m)


def measure_ramp(x_m: np.ndarray, values: np.ndarray) -> Ramp:
    """Crossings of a monotone edge between the plateaus at the two ends of the profile.

    The plateaus are the means of the outer ``PLATEAU_SHARE`` at each end. Raises MetricError without a step.
    """
    ends = max(1, round(PLATEAU_SHARE * values.size))
    before, after = float(values[:ends].mean()), float(values[-ends:].mean())
    if not abs(after - before) > LEAST_CONTRAST * np.abs(values).max():
        raise MetricError("no edge between the ends of the patch; put the patch across the shadow's edge")
    share = (values - before) / (after - before)
    x10, x50, x90 = (_crossing(x_m, share, level) for level in (0.1, 0.5, 0.9))
    return Ramp(x10, x50, x90, before, after)


def _crossing(x_m: np.ndarray, share: np.ndarray, level: float) -> float:
    """Where the profile passes ``level``: the mean of the first and the last passage, so that noise has no bias."""
    above = share >= level
    rising = np.flatnonzero(above[1:] != above[:-1])
    if rising.size == 0:
        raise MetricError(f"the profile does not pass {level:.0%} of its step; make the patch longer")

    def at(i: int) -> float:
        return float(x_m[i] + (x_m[i + 1] - x_m[i]) * (level - share[i]) / (share[i + 1] - share[i]))

    return 0.5 * (at(int(rising[0])) + at(int(rising[-1])))
