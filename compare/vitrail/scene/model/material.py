"""The paper's material, and what later work adds to it: patterns, microfacets, Abbe numbers, attenuation."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from vitrail.base.fault import Fault
from vitrail.scene.model.part import IS_COLOUR, Colour, Finite, Part, Positive, Share, spread

LIGHT_USE_SLACK = 4 * 2.220446049250313e-16
"""Decimal sums overshoot: .33 + .56 + .11 exceeds 1 by rounding alone, so 4 ulp are allowed [O 2.37]."""


class CheckerSquares(Part):
    """Two colours in squares of ``size`` metres along the surface coordinates of a flat shape."""

    colors: tuple[Colour, Colour]
    size: Positive


class Checker(Part):
    """A pattern instead of one colour; flat shapes (plane, rectangle, disc) only."""

    checker: CheckerSquares


Glass = Literal[
    "N-BK7",
    "N-K5",
    "N-BAK4",
    "N-SK16",
    "N-LAK8",
    "N-LASF44",
    "F2",
    "N-F2",
    "SF10",
    "N-SF10",
    "SF11",
    "N-SF11",
    "N-SF66",
    "fused-silica",
    "water",
]
"""The catalogue glasses a scene may name; ``optics/glass.py`` holds their constants."""


class Ggx(Part):
    """Microfacet roughness with the GGX distribution [W07 eq. 33]."""

    ggx: Annotated[float, Field(gt=0, le=1, strict=True)]


class Abbe(Part):
    """Dispersion from the Abbe number at the d line, V_d = (n_d - 1) / (n_F - n_C)."""

    abbe: Annotated[float, Field(gt=1, allow_inf_nan=False, strict=True)]


_Remaining = Annotated[float, Field(gt=0, le=1, strict=True)]


class Attenuation(Part):
    """White light has ``color`` left after ``distance`` metres inside (as in KHR_materials_volume)."""

    color: Annotated[tuple[_Remaining, _Remaining, _Remaining], spread(_Remaining), IS_COLOUR]
    distance: Positive


class Material(Part):
    """The paper's material: shares d, r, t of the light that meets a face, and what the inside does to it.

    ``diffuse + reflection + transmission`` is the light use ``lu`` [S eq. 6]; it may not exceed 1 in any channel.
    """

    diffuse: Share | Checker = (0.0, 0.0, 0.0)
    reflection: Share = (0.0, 0.0, 0.0)
    transmission: Share = (0.0, 0.0, 0.0)
    ior: Positive | None = None
    fresnel: Annotated[bool, Field(strict=True)] = False
    roughness: Annotated[float, Field(ge=0, le=1, strict=True)] | Ggx = 0.0
    dispersion: Finite | Abbe | None = None
    glass: Glass | None = None
    attenuation: Attenuation | None = None
    absorption_per_m: Colour | None = None
    emission: Colour | Checker | None = None

    @property
    def diffuse_peak(self) -> tuple[float, float, float]:
        """The largest diffuse share per channel over the surface."""
        if isinstance(self.diffuse, Checker):
            first, second = self.diffuse.checker.colors
            return (max(first[0], second[0]), max(first[1], second[1]), max(first[2], second[2]))
        return self.diffuse

    @property
    def light_use(self) -> tuple[float, float, float]:
        """lu = d + r + t per channel [S eq. 6], at its largest over the surface."""
        d, r, t = self.diffuse_peak, self.reflection, self.transmission
        return (d[0] + r[0] + t[0], d[1] + r[1] + t[1], d[2] + r[2] + t[2])

    @property
    def is_diffuse(self) -> bool:
        return max(self.diffuse_peak) > 0

    @property
    def is_transmissive(self) -> bool:
        return max(self.transmission) > 0

    @property
    def is_specular(self) -> bool:
        """Whether light leaves a face of this material in a mirrored or refracted direction."""
        return max(self.reflection) > 0 or self.is_transmissive

    @property
    def is_dispersive(self) -> bool:
        return self.is_transmissive and (
            self.glass is not None or isinstance(self.dispersion, Abbe) or self.dispersion not in (None, 0.0)
        )

    @model_validator(mode="after")
    def _conserve_light(self) -> Material:
        use = max(self.light_use)
        if use > 1 + LIGHT_USE_SLACK:
            channel = ["red", "green", "blue"][self.light_use.index(use)]
            raise Fault(
                f"diffuse + reflection + transmission is {use:.6g} in {channel}, which makes light",
                "lower one of them until the sum is at most 1",
            )
        return self

    @model_validator(mode="after")
    def _need_an_index(self) -> Material:
        if self.is_transmissive and self.ior is None and self.glass is None:
            raise Fault("a transmissive material needs its refraction index", "add `ior: 1.5` or a catalogue `glass:`")
        if self.ior is not None and self.glass is not None:
            raise Fault("both `ior` and `glass` give the refraction index", "keep one of them")
        if self.glass is not None and self.dispersion is not None:
            raise Fault("both `glass` and `dispersion` give the dispersion", "keep one of them")
        if self.attenuation is not None and self.absorption_per_m is not None:
            raise Fault("both `attenuation` and `absorption_per_m` give the absorption", "keep one of them")
        if self.fresnel and self.ior is None and self.glass is None:
            raise Fault("`fresnel` needs a refraction index", "add `ior: 1.5` or a catalogue `glass:`")
        if (self.attenuation or self.absorption_per_m) and not self.is_transmissive:
            raise Fault("an opaque material has no inside to absorb light", "add `transmission` or drop the absorption")
        return self
