"""Scan the whole picture of two engines: name every place where they differ, with its object, its layer and its size.

What the certificate states of a phenomenon is allowed of the light in the tracer's layer of it, pixel by pixel. A place
is a warning. It is a deviation, with the exit code of one, where it lies outside every patch, differs by several times
what is allowed, and would be seen: nothing else judges it there.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.camera import View
from vitrail.geometry.seen import seen_object
from vitrail.geometry.world import World
from vitrail.images.exr import ImageLayers, write_png
from vitrail.images.false_colour import signed_difference
from vitrail.judge.comparison import Verdict
from vitrail.judge.judgement import Residual
from vitrail.judge.scan_records import DifferentPlace, ScanResult
from vitrail.judge.scan_words import place_words
from vitrail.metrics.measurement import MetricError
from vitrail.metrics.scan import FALSE_ALARM_RATE, DifferentRegion, layer_of, scan

BASE = 0.02
"""Share of the light that may differ anywhere: four times the tolerance of a patch's mean (0.5 %), because a box of
5 x 5 pixels sees a gradient, a texture or a rim that a patch is laid to avoid."""

MOST_PLACES = 8
"""Places that are listed, those with the most light first."""

MARGIN = 3.0
"""Times the tolerance from which on a place deviates: what is allowed is known to a factor of 2."""

VISIBLE = 0.02
"""Share of the picture's mean light below which a difference is a warning at most: nobody sees it at this exposure."""

INSIDE = 0.5
"""A place belongs to the patch that holds this share of it."""

ACTS_ON: Mapping[str, tuple[Phenomenon, ...]] = {
    Phenomenon.DIFFUSION: (Phenomenon.DIFFUSION, Phenomenon.SHADOW, Phenomenon.INDIRECT_LIGHT),
    Phenomenon.REFLECTION: (Phenomenon.REFLECTION, Phenomenon.ROUGHNESS),
    Phenomenon.REFRACTION: (
        Phenomenon.REFRACTION,
        Phenomenon.COLOURED_TRANSMISSION,
        Phenomenon.ABSORPTION,
        Phenomenon.ROUGHNESS,
        Phenomenon.DISPERSION,
    ),
    Phenomenon.CAUSTIC: (
        Phenomenon.CAUSTIC,
        Phenomenon.COLOURED_TRANSMISSION,
        Phenomenon.ABSORPTION,
        Phenomenon.ROUGHNESS,
        Phenomenon.DISPERSION,
    ),
}
"""What a certificate says of a phenomenon acts on these layers; a layer without a row has its own name's."""


def scan_images(
    world: World, images: Mapping[str, ImageLayers], residual: Residual, place: Path | None = None
) -> ScanResult | None:
    """Hold the tracer's whole picture against POV-Ray's; None where a picture, its halves or its size are missing.

    ``residual`` is the certificate's. The difference over its noise is drawn into ``place``.
    """
    tracer, povray = images.get("tracer"), images.get("povray")
    if tracer is None or povray is None:
        return None
    halves = [(each.half_a, each.half_b) for each in (tracer, povray)]
    known = [(a, b) for a, b in halves if a is not None and b is not None]
    if len(known) < 2:
        return None
    try:
        found = scan(tracer.radiance, povray.radiance, (known[0], known[1]), BASE + _stated(tracer, residual))
    except MetricError:
        return None
    light = float(tracer.radiance.mean() + povray.radiance.mean()) / 2
    # Take the size of the picture from the picture: people's pictures are larger than scenes say.
    view = replace(world.view, width=tracer.width, height=tracer.height)
    patches = _patch_masks(world, view)
    listed = [_place(each, world, view, tracer, povray, patches, light) for each in found.regions[:MOST_PLACES]]
    return ScanResult(
        threshold=found.threshold,
        false_alarm_rate=FALSE_ALARM_RATE,
        picture=_picture(found.over_noise, found.threshold, place),
        places=tuple(listed),
        more=len(found.regions) - len(listed),
        verdict=Verdict.DEVIATES if any(each.deviates for each in listed) else Verdict.AGREES,
    )


def _stated(tracer: ImageLayers, residual: Residual) -> np.ndarray:
    """What the certificate allows of each pixel, (height, width), as a share of its light."""
    light = np.maximum(np.abs(tracer.radiance).mean(axis=-1), np.finfo(float).tiny)
    allowed = np.zeros(light.shape)
    for name, layer in tracer.layers.items():
        acting = ACTS_ON.get(name) or ((Phenomenon(name),) if name in set(Phenomenon) else ())
        allowed += sum(residual(each, 1.0) for each in acting) * np.abs(layer).mean(axis=-1)
    return np.minimum(allowed / light, 1.0)


def _place(
    region: DifferentRegion,
    world: World,
    view: View,
    tracer: ImageLayers,
    povray: ImageLayers,
    patches: Mapping[str, np.ndarray],
    light: float,
) -> DifferentPlace:
    rows, columns = np.nonzero(region.mask)
    # Take the pixel of the region that is nearest to its middle: the middle of a ring is not on it.
    middle = int(np.argmin((rows - rows.mean()) ** 2 + (columns - columns.mean()) ** 2))
    y, x = int(rows[middle]), int(columns[middle])
    inside = tuple(name for name, mask in patches.items() if (mask & region.mask).sum() > INSIDE * region.pixels)
    gross = abs(region.difference) > max(MARGIN * region.tolerance, VISIBLE * light)
    seen = seen_object(world, view, x + 0.5, y + 0.5)
    layer = layer_of(region, tracer.radiance - povray.radiance, dict(tracer.layers))
    return DifferentPlace(
        x_px=x,
        y_px=y,
        width_px=int(np.ptp(columns)) + 1,
        height_px=int(np.ptp(rows)) + 1,
        pixels=region.pixels,
        object=seen,
        layer=layer,
        tracer=region.candidate,
        povray=region.reference,
        tolerance=region.tolerance,
        standard_error=region.standard_error,
        excess=min(region.excess, 1e6),
        observations=inside,
        deviates=gross and not inside,
        words=place_words(region, x, y, seen, layer, inside),
    )


def _patch_masks(world: World, view: View) -> dict[str, np.ndarray]:
    """The pixels of every observed patch as the camera sees it, by observation."""
    masks = {}
    columns, rows = np.meshgrid(np.arange(view.width) + 0.5, np.arange(view.height) + 0.5)
    for entry in world.scene.observe:
        center, u, v = (np.asarray(each, float) for each in (entry.patch.center, entry.patch.u, entry.patch.v))
        x, y, depth = view.project(np.stack([center - u - v, center + u - v, center + u + v, center - u + v]))
        if (depth > 0).all():
            masks[entry.name] = _within(columns, rows, x, y)
    return masks


def _within(columns: np.ndarray, rows: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Which pixels lie within a convex outline, whichever way round it goes."""
    sides = [(x[k - 3] - x[k]) * (rows - y[k]) - (y[k - 3] - y[k]) * (columns - x[k]) >= 0 for k in range(len(x))]
    return np.all(sides, axis=0) | ~np.any(sides, axis=0)


def _picture(over_noise: np.ndarray, threshold: float, place: Path | None) -> str:
    """The difference over its noise, red where the tracer is brighter; its path from the folder of the results."""
    if place is None:
        return ""
    field = np.repeat(over_noise[..., None], 3, axis=-1)
    path = place / "over_noise.png"
    write_png(path, signed_difference(field, np.zeros_like(field), scale=threshold))
    return Path(os.path.relpath(path, place.parent)).as_posix()
