"""What one POV-Ray run shows of the scene: which colour channel, which band of light, and at which brightness.

Photons keep 8 bits per channel relative to their brightest one, lose everything at a flux of 32, and are truncated
unless their mantissa has 8 bits [P 2.4]. So every run multiplies all light by one factor, undone in the image, and a
run may show a single channel of lights and materials as grey.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vitrail.base.colour import Triplet


@dataclass(frozen=True)
class Exposure:
    """``channel`` None shows all three; ``light_factor`` multiplies every radiance of the run's image.

    A run of one channel stands for all of ``stands_for``, which the scene treats alike. A run of one ``band`` counts
    by the band's ``weight``. ``half`` says which of the two half images the run belongs to.
    """

    channel: int | None = None
    light_factor: float = 1.0
    stands_for: tuple[int, ...] = (0, 1, 2)
    band: int | None = None
    weight: Triplet = (1.0, 1.0, 1.0)
    half: str = "a"

    @property
    def name(self) -> str:
        """What the run shows, for file names; empty where it shows everything."""
        channels = [("red", "green", "blue")[index] for index in self.stands_for] if self.channel is not None else []
        bands = [f"band{self.band + 1}"] if self.band is not None else []
        return "_".join([*bands, *channels])

    def share(self, colour: Sequence[float]) -> Triplet:
        """A dimensionless colour (albedo, transmission) as this run sees it."""
        if self.channel is None:
            return (colour[0], colour[1], colour[2])
        return (colour[self.channel],) * 3

    def light(self, colour: Sequence[float]) -> Triplet:
        """A radiometric colour as this run sees it, with the factor."""
        red, green, blue = self.share(colour)
        return (red * self.light_factor, green * self.light_factor, blue * self.light_factor)

    @property
    def gain(self) -> Triplet:
        """What the run's image is multiplied by, per channel, before the runs of one half are added."""
        red, green, blue = (
            self.weight[index] / self.light_factor if index in self.stands_for else 0.0 for index in range(3)
        )
        return (red, green, blue)
