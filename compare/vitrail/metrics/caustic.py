"""Light that glass has gathered: how much of it, where, and how tightly.

Never a bare maximum: the brightest pixel of a caustic grows with resolution without end.
"""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.encircled import ring_weights
from vitrail.metrics.measurement import Context, Measurement, MetricError, PatchAxis, per_channel
from vitrail.metrics.profile import PhenomenonLight, light_of, profile
from vitrail.metrics.radiance import channel_ratios

FLUX = "W sr^-1"


def caustic_flux(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Radiance summed over the patch, or over ``context.outer_radius_m`` about ``context.centre_m``.

    Absolute: ``caustic_flux.<channel>``, W/sr; comparison: ``flux_ratio.<channel>``.

    A caustic that one image lost gives a ratio at the bound of ``channel_ratios``; one that both lack is a
    MetricError.
    """
    light, other = light_of(("caustic",), candidate, reference, context)
    settings = {**light.settings, "centre_m": context.centre_m, "outer_radius_m": context.outer_radius_m}
    ours = _flux(light, candidate, context)
    if reference is None or other is None:
        return per_channel("caustic_flux", ours, FLUX, None, settings=settings, caveats=light.caveats)
    ratios = channel_ratios("flux_ratio", ours, _flux(other, reference, context), settings, light.caveats)
    if not ratios:
        raise MetricError("neither image has a caustic on the patch; correct the patch or the scene")
    return ratios


def caustic_centroid(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Centre of flux, metres from the patch centre: ``centroid.u/.v``, or ``centroid_shift.u/.v`` with ideal 0.

    Components and not the distance: a distance is above 0 by noise alone.
    """
    light, other = light_of(("caustic",), candidate, reference, context)
    ours = centroid(light, candidate, context)
    settings = light.settings
    if reference is None or other is None:
        return [
            Measurement(f"centroid.{axis}", x, "m", None, settings, caveats=light.caveats)
            for axis, x in zip("uv", ours, strict=True)
        ]
    theirs = centroid(other, reference, context)
    parts = {"distance": float(np.hypot(ours[0] - theirs[0], ours[1] - theirs[1]))}
    return [
        Measurement(f"centroid_shift.{axis}", x - y, "m", 0.0, settings, parts, light.caveats)
        for axis, x, y in zip("uv", ours, theirs, strict=True)
    ]


def caustic_rings(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Mean radiance (mean of the channels) between the radii ``context.annulus_edges_m`` about the centre.

    Absolute: ``annulus_mean.<k>``; comparison: ``annulus_ratio.<k>``, ideal 1. Nothing where no radii are asked for.
    """
    if len(context.annulus_edges_m) < 2:
        return []
    light, other = light_of(("caustic",), candidate, reference, context)
    centre = centre_of(light if other is None else other, candidate if reference is None else reference, context)
    edges = tuple(context.annulus_edges_m)
    settings = {**light.settings, "centre_m": centre, "edges_m": edges}
    ours = _ring_means(light, candidate, centre, edges)
    if reference is None or other is None:
        unit = "W sr^-1 m^-2"
        return [
            Measurement(f"annulus_mean.{k}", x, unit, None, settings, caveats=light.caveats) for k, x in enumerate(ours)
        ]
    theirs = _ring_means(other, reference, centre, edges)
    return [
        Measurement(f"annulus_ratio.{k}", x / y, "1", 1.0, settings, {"candidate": x, "reference": y}, light.caveats)
        for k, (x, y) in enumerate(zip(ours, theirs, strict=True))
        if y > 0
    ]


def caustic_area(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Area brighter than a threshold: ``area`` in m^2, or ``area_ratio`` with ideal 1.

    The threshold is ``context.threshold_radiance``; a comparison without one takes twice the reference's mean. Cells
    count by how far they are above it (a ramp of +-10 %), so that one noisy cell does not jump from nothing to whole.
    """
    light, other = light_of(("caustic",), candidate, reference, context)
    threshold = context.threshold_radiance
    if threshold is None:
        if other is None:
            return []
        threshold = 2 * float(_counted(other, candidate, context).mean())
    if not threshold > 0:
        raise MetricError("the threshold is not above 0; give threshold_radiance, or look why there is no caustic")
    settings = {**light.settings, "threshold": threshold, "ramp": 0.1}
    ours = _area(light, candidate, context, threshold)
    if reference is None or other is None:
        return [Measurement("area", ours, "m^2", None, settings, caveats=light.caveats)]
    theirs = _area(other, reference, context, threshold)
    if not theirs > 0:
        return []
    parts = {"candidate": ours, "reference": theirs}
    return [Measurement("area_ratio", ours / theirs, "1", 1.0, settings, parts, light.caveats)]


def profile_correlation(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Correlation of the two profiles (mean of channels) through the patch: ``profile_correlation.u/.v``, ideal 1.

    Noise lowers it; the floor says by how much. It sees shape alone: not flux, not exposure. A direction in which both
    profiles are flat but for their noise has no shape to compare and is left out.
    """
    if reference is None:
        return []
    light, other = light_of(("caustic",), candidate, reference, context)
    assert other is not None
    found = []
    for axis in ("u", "v"):
        ours = profile(light.values, candidate, axis)[1].mean(axis=-1)
        theirs = profile(other.values, reference, axis)[1].mean(axis=-1)
        spread = np.std(ours) * np.std(theirs)
        if not spread > 0:
            raise MetricError("a profile of the caustic is flat; there is no caustic to correlate")
        if _is_flat(ours, candidate, axis) and _is_flat(theirs, reference, axis):
            continue
        value = float(np.mean((ours - ours.mean()) * (theirs - theirs.mean())) / spread)
        settings = light.settings
        found.append(Measurement(f"profile_correlation.{axis}", value, "1", 1.0, settings, caveats=light.caveats))
    return found


FLAT_IN_NOISE = 3.0
"""A profile that varies by less than this many times its own noise has no shape of its own."""


def _is_flat(shape: np.ndarray, samples: PatchSamples, axis: PatchAxis) -> bool:
    """Whether a profile varies by no more than its noise does; never without half images."""
    if samples.noise is None:
        return False
    noise = profile(samples.noise, samples, axis)[1].mean(axis=-1)
    return bool(np.std(shape) <= FLAT_IN_NOISE * np.std(noise))


def centroid(light: PhenomenonLight, samples: PatchSamples, context: Context) -> tuple[float, float]:
    """(u, v) of the centre of flux, metres from the patch centre. Raises MetricError when there is no flux."""
    grey = _counted(light, samples, context).mean(axis=-1)
    total = grey.sum()
    if not total > 0:
        raise MetricError("no caustic flux on the patch; correct the patch, or look why the caustic is gone")
    return float((grey.sum(axis=0) * samples.u_m).sum() / total), float((grey.sum(axis=1) * samples.v_m).sum() / total)


def _flux(light: PhenomenonLight, samples: PatchSamples, context: Context) -> np.ndarray:
    """Radiance times area per channel (3,), W/sr."""
    return _counted(light, samples, context).sum(axis=(0, 1)) * samples.cell_area_m2


def _counted(light: PhenomenonLight, samples: PatchSamples, context: Context) -> np.ndarray:
    """The light (nv, nu, 3) times the share of each cell that is in the frame and within the outer radius."""
    seen = light.values * samples.coverage[..., None]
    if context.outer_radius_m is None:
        return seen
    if context.centre_m is None:
        raise MetricError("outer_radius_m needs centre_m: a circle has a centre")
    area = ring_weights(samples, context.centre_m, (0.0, context.outer_radius_m)).toarray()
    return seen * (area.reshape(samples.coverage.shape) / samples.cell_area_m2)[..., None]


def centre_of(light: PhenomenonLight, samples: PatchSamples, context: Context) -> tuple[float, float]:
    """The centre that the context knows, else the centroid."""
    return context.centre_m if context.centre_m is not None else centroid(light, samples, context)


def _ring_means(
    light: PhenomenonLight, samples: PatchSamples, centre: tuple[float, float], edges: tuple[float, ...]
) -> list[float]:
    weights = ring_weights(samples, centre, edges)
    area = np.asarray(weights.sum(axis=1)).ravel()
    if not (area > 0).all():
        raise MetricError(f"an annulus of {edges} holds no cell of the patch; choose radii on the patch")
    return [float(x) for x in (weights @ light.values.mean(axis=-1).ravel()) / area]


def _area(light: PhenomenonLight, samples: PatchSamples, context: Context, threshold: float) -> float:
    height = (_counted(light, samples, context).mean(axis=-1) / threshold - 0.9) / 0.2
    return float(np.clip(height, 0, 1).sum() * samples.cell_area_m2)
