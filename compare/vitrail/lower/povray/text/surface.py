"""A material on one object, as one POV-Ray run sees it."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.base.colour import Triplet
from vitrail.geometry.solid import Solid
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.roughness import Bumps
from vitrail.lower.povray.text.sdl import Statement, statement
from vitrail.scene.model import Material

GREY_SLACK = 1e-12
"""Channels closer than this are alike; decimal shares of a scene differ by rounding alone."""


@dataclass(frozen=True)
class Surface:
    """A material on one object in one run; ``seen`` is what the camera sees of the radiance it sends out."""

    material: Material
    placed: Solid
    exposure: Exposure
    normalisation: Normalisation
    has_ambient: bool = False
    bumps: Bumps | None = None
    seen: float = 1.0

    @property
    def scatters(self) -> tuple[Statement, ...]:
        """The finish of a scattering texture, which also answers to the scene's ambient irradiance."""
        diffuse = statement("diffuse", 1)
        return (statement("ambient", 1), diffuse) if self.has_ambient else (diffuse,)

    @property
    def pool(self) -> Triplet:
        """s = r + t per channel of this run."""
        return specular_pool(self.material, self.exposure)


def specular_pool(material: Material, exposure: Exposure) -> Triplet:
    r, t = exposure.share(material.reflection), exposure.share(material.transmission)
    return (min(1.0, r[0] + t[0]), min(1.0, r[1] + t[1]), min(1.0, r[2] + t[2]))


def is_layered(material: Material, exposure: Exposure) -> bool:
    """Whether glass is written as two layers: it scatters, and its channels differ in this run."""
    scatters = material.is_transmissive and material.is_diffuse and material.emission is None
    return scatters and not is_grey(specular_pool(material, exposure))


def is_grey(colour: Triplet) -> bool:
    return max(colour) - min(colour) <= GREY_SLACK
