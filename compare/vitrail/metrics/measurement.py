"""What a metric returns, and what it may know besides the samples.

A metric is a pure function ``(candidate, reference, context) -> list[Measurement]``. With ``reference`` None it returns
absolute quantities of one image (W sr^-1 m^-2, metres, degrees) to set against a closed form; with a reference it
returns comparisons whose ``ideal`` is the value of a perfect match. A name with a dot is one component of a family:
``flux_ratio.red``, ``centroid_shift.u``, ``annulus_mean.3``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
from scipy.special import stdtrit

from vitrail.base.colour import Triplet
from vitrail.images.patch import PatchSamples

CHANNELS = ("red", "green", "blue")
PatchAxis = Literal["u", "v"]


class MetricError(ValueError):
    """A metric was asked something it cannot answer; the message says what and what to do instead."""


@dataclass(frozen=True)
class StudentInterval:
    """The range that holds the true value with confidence ``level``, noise being the only cause of doubt.

    ``standard_error`` and ``degrees_of_freedom`` let a judge widen it to another level without measuring again.
    """

    low: float
    high: float
    level: float
    method: str
    standard_error: float
    degrees_of_freedom: float

    @classmethod
    def about(cls, value: float, standard_error: float, dof: float, level: float, method: str) -> StudentInterval:
        """Student's t interval about ``value``; ``dof`` may be infinite."""
        reach = float(stdtrit(dof, 0.5 + level / 2)) * standard_error if standard_error > 0 else 0.0
        return cls(value - reach, value + reach, level, method, standard_error, dof)

    def at_level(self, level: float) -> StudentInterval:
        middle = 0.5 * (self.low + self.high)
        return StudentInterval.about(middle, self.standard_error, self.degrees_of_freedom, level, self.method)


@dataclass(frozen=True)
class Measurement:
    """One number with everything needed to read it.

    ``ideal`` is None for an absolute quantity: its truth comes from a closed form. ``interval`` is None where no half
    images are known or the number is not continuous. ``floor`` is what the metric reads when noise alone separates the
    two images (the A/A value).
    """

    metric: str
    value: float
    unit: str
    ideal: float | None = None
    settings: Mapping[str, object] = field(default_factory=dict)
    parts: Mapping[str, object] = field(default_factory=dict)
    caveats: tuple[str, ...] = ()
    interval: StudentInterval | None = None
    floor: float | None = None

    @property
    def family(self) -> str:
        """The name without its component: ``flux_ratio`` of ``flux_ratio.red``."""
        return self.metric.split(".")[0]

    def with_caveat(self, caveat: str) -> Measurement:
        return replace(self, caveats=(*self.caveats, caveat))


@dataclass(frozen=True)
class Context:
    """What a metric may know besides the samples; every field has a neutral default and is never guessed.

    ``background``: radiance of the receiver without the observed light, (3,) or (nv, nu, 3).
    ``full_radiance``: what the receiver shows with nothing in the way (d E / pi), per channel; it turns a radiance into
    a transmittance. ``throw_m``: from the glass to the patch centre, it turns metres into degrees of deflection.
    ``view_distance_m``: from the camera to the patch centre, it turns metres into degrees of view.
    ``thickness_m`` and ``thickness_slope`` (metres of glass per metre of patch along ``along``): what light crossed.
    ``centre_m``: (u, v) of the symmetry centre, relative to the patch centre, for annuli about a known axis.
    ``outer_radius_m``: nothing further from that centre belongs to the caustic (beyond it the sun shines directly).
    ``annulus_edges_m``: ascending radii. ``threshold_radiance``: for the area of a caustic, mean of the channels.
    ``bands``: name to (r, g, b) weight of each dispersion band. ``furnace_radiance``: of a uniform surround.
    ``correlation_m``: length over which noise is correlated (the gather radius); blocks are never smaller.
    """

    along: PatchAxis = "u"
    background: np.ndarray | Triplet | None = None
    full_radiance: Triplet | None = None
    throw_m: float | None = None
    view_distance_m: float | None = None
    thickness_m: float | None = None
    thickness_slope: float | None = None
    centre_m: tuple[float, float] | None = None
    outer_radius_m: float | None = None
    annulus_edges_m: tuple[float, ...] = ()
    threshold_radiance: float | None = None
    bands: Mapping[str, Triplet] = field(default_factory=dict)
    furnace_radiance: Triplet | None = None
    correlation_m: float = 0.0


PatchMetric = Callable[[PatchSamples, PatchSamples | None, Context], list[Measurement]]
"""A metric: candidate, reference or None, and what else it may know."""


def per_channel(family: str, values: np.ndarray, unit: str, ideal: float | None, **rest: Any) -> list[Measurement]:
    """One measurement a channel, named ``family.red`` and so on."""
    return [
        Measurement(f"{family}.{name}", float(value), unit, ideal, **rest)
        for name, value in zip(CHANNELS, values, strict=True)
    ]
