"""Which metrics belong to which phenomenon: the one list. A new metric is its file, its test, and one name here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial

from vitrail.base.phenomenon import Phenomenon
from vitrail.images.patch import PatchSamples
from vitrail.metrics.absorption import absorption_fit, optical_depth
from vitrail.metrics.caustic import (
    caustic_area,
    caustic_centroid,
    caustic_flux,
    caustic_rings,
    profile_correlation,
)
from vitrail.metrics.caustic_radii import caustic_radii, caustic_radii_near
from vitrail.metrics.diffusion import evenness
from vitrail.metrics.dispersion import colour_order, spectrum_places, spectrum_spread
from vitrail.metrics.displacement import displacement, displacement_near, edge_place
from vitrail.metrics.energy import furnace_deviation
from vitrail.metrics.indirect import indirect_light
from vitrail.metrics.measurement import Context, Measurement, MetricError, PatchMetric
from vitrail.metrics.noise import with_interval
from vitrail.metrics.radiance import mean_radiance
from vitrail.metrics.roughness import blur, blur_near, contrast, contrast_near
from vitrail.metrics.shadow import penumbra
from vitrail.metrics.transmission import chromaticity_shift, colour_difference, transmittance

PICTURE: tuple[PatchMetric, ...] = (mean_radiance, displacement, edge_place, furnace_deviation)
"""What is seen through or in a face: how bright, and how far moved."""

BY_PHENOMENON: Mapping[Phenomenon, tuple[PatchMetric, ...]] = {
    Phenomenon.DIFFUSION: (mean_radiance, evenness, furnace_deviation),
    Phenomenon.REFLECTION: PICTURE,
    Phenomenon.REFRACTION: PICTURE,
    Phenomenon.TOTAL_INTERNAL_REFLECTION: PICTURE,
    Phenomenon.COLOURED_TRANSMISSION: (mean_radiance, transmittance, chromaticity_shift, colour_difference),
    Phenomenon.ABSORPTION: (mean_radiance, optical_depth, absorption_fit),
    Phenomenon.CAUSTIC: (
        caustic_flux,
        caustic_centroid,
        caustic_radii,
        caustic_rings,
        caustic_area,
        profile_correlation,
    ),
    Phenomenon.ROUGHNESS: (mean_radiance, blur, contrast),
    Phenomenon.DISPERSION: (caustic_flux, spectrum_places, spectrum_spread, colour_order),
    Phenomenon.SHADOW: (mean_radiance, penumbra),
    Phenomenon.INDIRECT_LIGHT: (mean_radiance, indirect_light),
}


NEAR: Mapping[PatchMetric, Callable[[PatchSamples, PatchSamples | None, Context], PatchMetric]] = {
    blur: blur_near,
    caustic_radii: caustic_radii_near,
    contrast: contrast_near,
    displacement: displacement_near,
}
"""What gives the numbers of a metric for images that differ little from these: faster, or the same of two forms."""


def measure(
    phenomenon: Phenomenon, candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> list[Measurement]:
    """Everything the phenomenon asks of the samples.

    Without a reference: absolute quantities of ``candidate``. With one: comparisons, each with its ideal. What one
    metric cannot answer is a caveat on the others; raises MetricError when none can.
    """
    found: list[Measurement] = []
    silent: list[str] = []
    for metric in BY_PHENOMENON[phenomenon]:
        try:
            found += metric(candidate, reference, context)
        except MetricError as reason:
            silent.append(f"{metric.__name__}: {reason}")
    if not found:
        raise MetricError("; ".join(silent) or f"nothing to measure for {phenomenon}")
    return [replace(m, caveats=(*m.caveats, *silent)) for m in found]


def measure_with_intervals(
    phenomenon: Phenomenon,
    candidate: PatchSamples,
    reference: PatchSamples | None,
    context: Context,
    *,
    level: float = 0.95,
) -> list[Measurement]:
    """As ``measure``, each number with its interval at ``level`` and, for comparisons, its A/A floor."""

    return with_interval(
        partial(measure, phenomenon),
        candidate,
        reference,
        context,
        near=_nearby(phenomenon, candidate, reference, context),
        level=level,
    )


def _nearby(
    phenomenon: Phenomenon, candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> PatchMetric:
    """``measure`` for images that differ from these by their noise."""
    metrics = [_near(metric, candidate, reference, context) for metric in BY_PHENOMENON[phenomenon]]

    def again(ours: PatchSamples, theirs: PatchSamples | None, known: Context) -> list[Measurement]:
        found: list[Measurement] = []
        for metric in metrics:
            with suppress(MetricError):
                found += metric(ours, theirs, known)
        return found

    return again


def _near(
    metric: PatchMetric, candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> PatchMetric:
    """The faster form of a metric, or itself; what cannot be measured here keeps its own words."""
    try:
        return NEAR[metric](candidate, reference, context) if metric in NEAR else metric
    except MetricError:
        return metric
