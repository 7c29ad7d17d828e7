"""Which metrics belong to which phenomenon: the one list. A new metric is its file, its test, and one name here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Protocol

from vitrail.images.patch import PatchSamples
from vitrail.metrics.absorption import absorption_fit, optical_depth
from vitrail.metrics.caustic import (
    caustic_area,
    caustic_centroid,
    caustic_flux,
    caustic_radii,
    caustic_rings,
    profile_correlation,
)
from vitrail.metrics.diffusion import evenness
from vitrail.metrics.dispersion import colour_order, spectrum_places, spectrum_spread
from vitrail.metrics.displacement import displacement, edge_place
from vitrail.metrics.energy import furnace_deviation
from vitrail.metrics.indirect import indirect_light
from vitrail.metrics.measurement import Axis, Context, Measurement, MetricError
from vitrail.metrics.noise import with_interval
from vitrail.metrics.radiance import mean_radiance
from vitrail.metrics.roughness import blur, contrast
from vitrail.metrics.shadow import penumbra
from vitrail.metrics.transmission import chromaticity_shift, colour_difference, transmittance

PatchMetric = Callable[[PatchSamples, PatchSamples | None, Context], list[Measurement]]

PICTURE: tuple[PatchMetric, ...] = (mean_radiance, displacement, edge_place, furnace_deviation)
"""What is seen through or in a face: how bright, and how far moved."""

BY_PHENOMENON: Mapping[str, tuple[PatchMetric, ...]] = {
    "diffusion": (mean_radiance, evenness, furnace_deviation),
    "reflection": PICTURE,
    "refraction": PICTURE,
    "total_internal_reflection": PICTURE,
    "coloured_transmission": (mean_radiance, transmittance, chromaticity_shift, colour_difference),
    "absorption": (mean_radiance, optical_depth, absorption_fit),
    "caustic": (
        caustic_flux,
        caustic_centroid,
        caustic_radii,
        caustic_rings,
        caustic_area,
        profile_correlation,
    ),
    "roughness": (mean_radiance, blur, contrast),
    "dispersion": (caustic_flux, spectrum_places, spectrum_spread, colour_order),
    "shadow": (mean_radiance, penumbra),
    "indirect_light": (mean_radiance, indirect_light),
}


class Observed(Protocol):
    """What is asked of an observation of the scene: its phenomenon and, if it has one, its direction."""

    @property
    def phenomenon(self) -> str: ...
    @property
    def along(self) -> Axis | None: ...


def measure(
    observation: Observed, candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> list[Measurement]:
    """Everything the phenomenon of ``observation`` asks of the samples.

    Without a reference: absolute quantities of ``candidate``. With one: comparisons, each with its ideal. What one
    metric cannot answer is a caveat on the others; raises MetricError when none can.
    """
    known = context if observation.along is None else replace(context, along=observation.along)
    found: list[Measurement] = []
    silent: list[str] = []
    for metric in BY_PHENOMENON[observation.phenomenon]:
        try:
            found += metric(candidate, reference, known)
        except MetricError as reason:
            silent.append(f"{metric.__name__}: {reason}")
    if not found:
        raise MetricError("; ".join(silent) or f"nothing to measure for {observation.phenomenon}")
    return [replace(m, caveats=(*m.caveats, *silent)) for m in found]


def measure_with_intervals(
    observation: Observed,
    candidate: PatchSamples,
    reference: PatchSamples | None,
    context: Context,
    *,
    level: float = 0.95,
) -> list[Measurement]:
    """As ``measure``, each number with its interval at ``level`` and, for comparisons, its A/A floor."""

    def everything(ours: PatchSamples, theirs: PatchSamples | None, known: Context) -> list[Measurement]:
        return measure(observation, ours, theirs, known)

    return with_interval(everything, candidate, reference, context, level=level)
