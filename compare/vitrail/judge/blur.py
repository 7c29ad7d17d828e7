"""A patch spread once more by what blurred its image already: the numbers then move about as far again.

Spreading light over a mean square distance s along each axis changes it by s / 2 of its curvature, so the second time
changes it as the first time did, to the first order of s and where light is smooth. What was sharper before loses more
the first time: ``SAFETY`` is for that.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from scipy.ndimage import correlate1d

from vitrail.images.patch import PatchSamples

SAFETY = 1.5
"""What the first blur did over what the second does. In the caustic of a ball lens, made of beams without noise, it is
1.3 in the innermost ring, with pixels of 1/60 and of 1/180 of the patch, and 1.0 to 1.6 in the next."""

GATHERED = "caustic"
"""The layer that is summed over gather discs."""

PIXEL_VARIANCE = 2 / 12
"""Square cells along each axis: a pixel is a mean over its width, a cell of the patch over the pixels it covers."""


def gathered_again(samples: PatchSamples, radius_m: float) -> PatchSamples:
    """The gathered light averaged over one more disc: r^2 / 4 is the mean square distance in it along an axis."""
    gathered = samples.layers.get(GATHERED)
    if gathered is None:
        return samples
    spread = gathered
    for axis, cell_m in ((0, samples.cell_v_m), (1, samples.cell_u_m)):
        spread = diffused(spread, axis, (radius_m / 2 / cell_m) ** 2)
    return replace(samples, values=samples.values + (spread - gathered), layers={**samples.layers, GATHERED: spread})


def pixelled_again(samples: PatchSamples) -> PatchSamples:
    """All light averaged once more over pixels and cells; less was lost where the cells of the patch are pixels."""

    def spread(light: np.ndarray) -> np.ndarray:
        return diffused(diffused(light, 0, PIXEL_VARIANCE), 1, PIXEL_VARIANCE)

    layers = {name: spread(layer) for name, layer in samples.layers.items()}
    return replace(samples, values=spread(samples.values), layers=layers)


def diffused(light: np.ndarray, axis: int, variance: float) -> np.ndarray:
    """Light (nv, nu, 3) spread along an axis by ``variance`` (square cells) exactly, none of it over the border.

    Steps of at most half a square cell by the three-point kernel (v/2, 1 - v, v/2), which has variance v whatever the
    cell; a sampled Gaussian narrower than a cell has not.
    """
    steps = max(1, math.ceil(2 * variance))
    each = variance / steps
    for _ in range(steps):
        light = correlate1d(light, [each / 2, 1 - each, each / 2], axis, mode="reflect")
    return light
