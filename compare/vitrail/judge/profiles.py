"""Radiance along a patch for every side, and by formula where one is known: for people, not for verdicts."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from vitrail.images.display import luminance
from vitrail.images.patch import PatchSamples
from vitrail.judge.comparison import Curve, Profile
from vitrail.judge.references import TrueProfile
from vitrail.metrics.measurement import MetricError, PatchAxis
from vitrail.metrics.profile import profile
from vitrail.scene.model import Observation

UNIT = "W sr^-1 m^-2"
NEIGHBOURS = 9
"""One half difference is one draw of the noise; this many neighbours together estimate its size."""


def profiles_of(
    observation: Observation, samples: Mapping[str, PatchSamples], truth: TrueProfile | None
) -> tuple[Profile, ...]:
    """Luminance along the observation's direction, or along both where it has none; none where the patch is cut off."""
    axes: tuple[PatchAxis, ...] = ("u", "v") if observation.along is None else (observation.along,)
    first = next(iter(samples.values()))
    cells = {"u": first.u_m.size, "v": first.v_m.size}
    try:
        return tuple(_profile(axis, samples, truth) for axis in axes if cells[axis] > 1)
    except MetricError:
        return ()


def _profile(axis: PatchAxis, samples: Mapping[str, PatchSamples], truth: TrueProfile | None) -> Profile:
    """One curve a side. The sides share one grid, and a formula is read at its positions."""
    positions = next(iter(samples.values())).u_m if axis == "u" else next(iter(samples.values())).v_m
    curves = [_curve(axis, side, sample) for side, sample in samples.items()]
    if truth is not None and truth.along == axis:
        values = np.interp(positions, truth.positions_m, truth.values)
        curves.append(Curve(side="truth", values=tuple(values.tolist())))
    return Profile(
        along=axis, channel="luminance", unit=UNIT, positions_m=tuple(positions.tolist()), curves=tuple(curves)
    )


def _curve(axis: PatchAxis, side: str, sample: PatchSamples) -> Curve:
    _, values = profile(sample.values, sample, axis)
    error: tuple[float, ...] = ()
    if sample.noise is not None:
        draw = luminance(profile(sample.noise, sample, axis)[1])
        window = np.ones(min(NEIGHBOURS, draw.size))
        size = np.convolve(draw**2, window, mode="same") / np.convolve(np.ones_like(draw), window, mode="same")
        error = tuple(np.sqrt(size).tolist())
    return Curve(side=side, values=tuple(luminance(values).tolist()), standard_error=error)
