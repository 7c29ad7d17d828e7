"""The running sums of an image over its passes: as large after a thousand passes as after one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from vitrail.images.exr import ImageLayers

RADIANCE, HALF_A, HALF_B = "R G B", "half_a", "half_b"
"""Names of the sums that are no layer; the first is no name that a layer can have."""


@dataclass(frozen=True)
class Sums:
    """Sums over ``count`` passes by name, float64 (height, width, 3), added in the order of the passes.

    A pass has two independent halves. The sums of all first and of all second halves are independent too, and both
    hold passes of every radius: half their difference is the noise of the mean and nothing else.
    """

    count: int = 0
    arrays: Mapping[str, np.ndarray] = field(default_factory=dict)

    def with_pass(self, image: ImageLayers) -> Sums:
        """These sums and one more pass; a layer that a pass lacks is black in it."""
        assert image.half_a is not None and image.half_b is not None
        found = {RADIANCE: image.radiance, HALF_A: image.half_a, HALF_B: image.half_b, **image.layers}
        names, black = dict.fromkeys([*self.arrays, *found]), np.zeros_like(image.radiance)
        return Sums(self.count + 1, {name: self.arrays.get(name, black) + found.get(name, black) for name in names})

    def mean(self) -> ImageLayers:
        """The image of the finished passes, with its halves, variance and layers; there is at least one pass."""
        means = {name: array / self.count for name, array in self.arrays.items()}
        half_a, half_b = means.pop(HALF_A), means.pop(HALF_B)
        return ImageLayers(
            radiance=means.pop(RADIANCE),
            half_a=half_a,
            half_b=half_b,
            variance=((half_a - half_b) / 2) ** 2,
            layers=means,
        )

    def noise(self) -> float:
        """Root mean square of half the difference of the halves, over the mean radiance; 0 in a black image."""
        light = float(self.arrays[RADIANCE].mean())
        apart = (self.arrays[HALF_A] - self.arrays[HALF_B]) / 2
        return float(np.sqrt((apart**2).mean())) / light if light > 0 else 0.0
