"""Noise of a difference when both images were drawn with the same random numbers.

A rendering made again with the settings and the seed of its stored reference has nearly the same noise, so the noise of
their difference is far less than that of two independent images; for an unchanged program it is nothing at all.
"""

from __future__ import annotations

from dataclasses import replace

from vitrail.images.exr import ImageLayers


def with_common_noise(candidate: ImageLayers, reference: ImageLayers) -> tuple[ImageLayers, ImageLayers]:
    """The same two images with halves that hold the noise of their difference.

    The difference has halves of its own, a - a' and b - b'; half of what sets those apart is given to the candidate,
    and none to the reference. Images without halves come back as they are.
    """
    if candidate.half_a is None or candidate.half_b is None or reference.half_a is None or reference.half_b is None:
        return candidate, reference
    noise = ((candidate.half_a - reference.half_a) - (candidate.half_b - reference.half_b)) / 2
    shaken = replace(candidate, half_a=candidate.radiance + noise, half_b=candidate.radiance - noise)
    return shaken, replace(reference, half_a=reference.radiance, half_b=reference.radiance)
