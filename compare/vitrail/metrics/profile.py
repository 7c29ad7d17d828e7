"""Radiance along one direction of a patch, averaged across the other; and the light that an observation is about."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Axis, Context, MetricError


@dataclass(frozen=True)
class Light:
    """Radiance that belongs to one phenomenon (nv, nu, 3), and where it was taken from."""

    values: np.ndarray
    source: str
    caveats: tuple[str, ...] = ()


def light_of(
    phenomena: tuple[str, ...], candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> tuple[Light, Light | None]:
    """The light of a phenomenon in each image, taken the same way from both.

    ``phenomena`` are layer names in order of preference; the first with any light on the patch counts. Taken from, in
    this order: that layer, if every image has it; the radiance less ``context.background``; the radiance less what the
    other layers of whichever image has them hold; and failing all, the whole radiance, with a caveat.
    """
    images = [image for image in (candidate, reference) if image is not None]
    lit = [name for name in phenomena if any(np.any(image.layers.get(name, 0.0)) for image in images)]
    layer = (lit or phenomena)[0]
    if all(layer in image.layers for image in images):
        found = [Light(image.layers[layer], f"layer {layer}") for image in images]
    elif context.background is not None:
        background = np.broadcast_to(np.asarray(context.background, float), candidate.values.shape)
        found = [Light(image.values - background, "radiance less the known background") for image in images]
    elif any(layer in image.layers for image in images):
        owner = next(image for image in images if layer in image.layers)
        background = owner.values - owner.layers[layer]
        caveat = "one image has no layers; the other's light without this phenomenon was taken off both"
        found = [
            Light(image.values - background, "radiance less the other image's rest", (caveat,)) for image in images
        ]
    else:
        caveat = f"no {layer} layer and no background known: all radiance on the patch counts"
        found = [Light(image.values, "radiance", (caveat,)) for image in images]
    return found[0], found[1] if reference is not None else None


def profile(values: np.ndarray, samples: PatchSamples, along: Axis) -> tuple[np.ndarray, np.ndarray]:
    """Positions (n,), metres from the patch centre, and mean radiance there (n, 3). Raises MetricError off frame."""
    across = 0 if along == "u" else 1
    weight = samples.coverage[..., None]
    total = weight.sum(axis=across)
    if not (total > 0).all():
        raise MetricError(f"part of the patch along {along} is outside the image; move the patch or the camera")
    positions = samples.u_m if along == "u" else samples.v_m
    return positions, (values * weight).sum(axis=across) / total


def cell_m(samples: PatchSamples, along: Axis) -> float:
    """The edge of a cell along one direction, metres."""
    return samples.cell_u_m if along == "u" else samples.cell_v_m


def degrees_at(length_m: float, distance_m: float) -> float:
    """The angle that a length seen at right angles subtends at a distance."""
    return float(np.degrees(np.arctan2(length_m, distance_m)))
