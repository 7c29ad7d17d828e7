"""A picture with several of its pixels averaged into one, for numbers that want the scene's own pixels."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from vitrail.images.exr import ImageLayers


def coarser(image: ImageLayers, times: int) -> ImageLayers:
    """The radiance and the halves, averaged over squares of ``times`` pixels along each edge; layers stay behind."""
    if times == 1:
        return image
    half_a, half_b = (None if half is None else averaged(half, times) for half in (image.half_a, image.half_b))
    return replace(
        image, radiance=averaged(image.radiance, times), half_a=half_a, half_b=half_b, variance=None, layers={}
    )


def averaged(pixels: np.ndarray, times: int) -> np.ndarray:
    """(height, width, 3) to a ``times``-th of both. Raises ValueError where that leaves a rest."""
    height, width = pixels.shape[0] // times, pixels.shape[1] // times
    result: np.ndarray = pixels.reshape(height, times, width, times, -1).mean(axis=(1, 3))
    return result
