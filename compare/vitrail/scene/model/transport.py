"""How far light is followed, by which bands, and which literal readings of the paper are switched on."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from vitrail.scene.model.part import Colour, Part


class Ambient(Part):
    """Constant irradiance on every diffuse surface, the stand-in for indirect light that the paper names."""

    ambient: Colour


class SpectralBands(Part):
    spectral: Annotated[int, Field(ge=2, le=256, strict=True)]


class Transport(Part):
    """What light may do on its way, where a scene wants more or less than the defaults."""

    indirect: Literal["none", "photons"] | Ambient = "none"
    max_reflections: Annotated[int, Field(ge=0, le=1000, strict=True)] = 8
    max_transmissions: Annotated[int, Field(ge=0, le=1000, strict=True)] = 64
    bands: Literal["paper", "povray", "continuous"] | SpectralBands = "paper"


class Paper(Part):
    """Literal readings of the paper that ``docs/sources.md`` calls wrong, each switched on by name."""

    tir: Literal["reflect", "drop"] = "reflect"
    refraction: Literal["corrected", "literal"] = "corrected"
    literal_sum: Annotated[bool, Field(strict=True)] = False
    dispersion: Literal["step", "span"] = "step"
    dispersion_reference: Literal["red", "d_line", "middle"] = "red"
    disperse_camera: Annotated[bool, Field(strict=True)] = True
    rough_samples: Annotated[int, Field(ge=1, le=256, strict=True)] = 1
    count_transmission: Annotated[bool, Field(strict=True)] = False
    shadow: Literal["opaque", "filter"] = "opaque"
    rough_photons: Literal["reciprocal", "literal"] = "reciprocal"
