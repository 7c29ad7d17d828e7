"""Radiance along one direction of a patch, averaged across the other; and the light that an observation is about."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Context, MetricError, PatchAxis


@dataclass(frozen=True)
class PhenomenonLight:
    """Radiance that belongs to one phenomenon (nv, nu, 3), and where it was taken from.

    ``whole_over_light``: how many times larger the radiance is from which it was taken as a difference, in the channel
    where most; what rounds the radiance rounds the light as many times more. 1 where nothing was taken off.
    """

    values: np.ndarray
    source: str
    caveats: tuple[str, ...] = ()
    whole_over_light: float = 1.0

    @property
    def settings(self) -> dict[str, object]:
        """What a measurement says about the light that it was taken of."""
        return {"light": self.source, "whole_over_light": self.whole_over_light}


def light_of(
    phenomena: tuple[str, ...], candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> tuple[PhenomenonLight, PhenomenonLight | None]:
    """The light of a phenomenon in each image, taken the same way from both.

    ``phenomena`` are layer names in order of preference; the first with any light on the patch counts. Taken from, in
    this order: that layer, if every image has it; the radiance less ``context.background``; the radiance less what the
    other layers of whichever image has them hold; and failing all, the whole radiance, with a caveat.
    """
    images = [image for image in (candidate, reference) if image is not None]
    lit = [name for name in phenomena if any(np.any(image.layers.get(name, 0.0)) for image in images)]
    layer = (lit or phenomena)[0]
    if all(layer in image.layers for image in images):
        found = [PhenomenonLight(image.layers[layer], f"layer {layer}") for image in images]
    elif context.background is not None:
        background = np.broadcast_to(np.asarray(context.background, float), candidate.values.shape)
        source = "radiance less the known background"
        found = [_difference(image, background, source) for image in images]
    elif any(layer in image.layers for image in images):
        owner = next(image for image in images if layer in image.layers)
        background = owner.values - owner.layers[layer]
        caveat = "one image has no layers; the other's light without this phenomenon was taken off both"
        source = "radiance less the other image's rest"
        found = [_difference(image, background, source, (caveat,)) for image in images]
    else:
        caveat = f"no {layer} layer and no background known: all radiance on the patch counts"
        found = [PhenomenonLight(image.values, "radiance", (caveat,)) for image in images]
    return found[0], found[1] if reference is not None else None


def _difference(
    image: PatchSamples, background: np.ndarray, source: str, caveats: tuple[str, ...] = ()
) -> PhenomenonLight:
    """The radiance less a background, and how much more it was before."""
    left = image.values - background
    whole, light = (np.abs(each.mean(axis=(0, 1))) for each in (image.values, left))
    ratio = float(np.max(whole[light > 0] / light[light > 0], initial=1.0))
    return PhenomenonLight(left, source, caveats, ratio)


def profile(values: np.ndarray, samples: PatchSamples, along: PatchAxis) -> tuple[np.ndarray, np.ndarray]:
    """Positions (n,), metres from the patch centre, and mean radiance there (n, 3). Raises MetricError off frame."""
    across = 0 if along == "u" else 1
    weight = samples.coverage[..., None]
    total = weight.sum(axis=across)
    if not (total > 0).all():
        raise MetricError(f"part of the patch along {along} is outside the image; move the patch or the camera")
    positions = samples.u_m if along == "u" else samples.v_m
    return positions, (values * weight).sum(axis=across) / total


def cell_m(samples: PatchSamples, along: PatchAxis) -> float:
    """The edge of a cell along one direction, metres."""
    return samples.cell_u_m if along == "u" else samples.cell_v_m


def degrees_at(length_m: float, distance_m: float) -> float:
    """The angle that a length seen at right angles subtends at a distance."""
    return float(np.degrees(np.arctan2(length_m, distance_m)))
