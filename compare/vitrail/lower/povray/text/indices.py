"""Which refraction index a material has in one run: one number, one band's, or POV-Ray's own dispersion.

Slices are exact for any n(lambda): each run knows one index a material. The native law, n = ior D^((555 - nm) / 350),
has two numbers, fitted to the bands; what it misses goes into the certificate [P 3.2].
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal

from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.sdl import Statement, statement
from vitrail.optics.bands import Band
from vitrail.optics.dispersion import ior_by_band, reference_ior
from vitrail.optics.dispersion_fit import PovrayDispersion, fit
from vitrail.scene.model import Material, Scene

SINGLE_PRECISION = 2.0**-24
"""POV-Ray keeps an index in single precision [O 1.6]."""


@dataclass(frozen=True)
class Indices:
    """The indices of a scene under one mode; ``bands`` is one band of all light where nothing disperses."""

    scene: Scene
    bands: tuple[Band, ...]
    is_sliced: bool

    def sdl(self, material: Material, exposure: Exposure, is_shooting: bool) -> tuple[Statement, ...]:
        """The index statements of an ``interior``."""
        if exposure.band is not None:
            return (statement("ior", self._in_band(material, exposure.band, is_shooting)),)
        law = self.native_law(material)
        if law is None:
            return (statement("ior", reference_ior(material)),)
        return (
            statement("ior", law.ior),
            statement("dispersion", law.dispersion),
            statement("dispersion_samples", max(2, len(self.bands))),
        )

    def shown(self, material: Material, exposure: Exposure) -> float:
        """The index that the camera's rays meet in a run; where they split into colours in it, the reference."""
        return reference_ior(material) if exposure.band is None else self._in_band(material, exposure.band, False)

    def native_law(self, material: Material) -> PovrayDispersion | None:
        """POV-Ray's dispersion of a material; None where it has one index, or where runs are slices."""
        if self.is_sliced or len(self.bands) < 2 or not material.is_dispersive:
            return None
        wavelengths = [band.wavelength_nm for band in self.bands if band.wavelength_nm is not None]
        return fit(wavelengths, ior_by_band(material, self.bands, self.scene.paper))

    def rounding(self, material: Material) -> float:
        """Relative error of n - 1 when n is kept in single precision; large next to 1."""
        excess = abs(float(Decimal(repr(reference_ior(material))) - 1))
        return SINGLE_PRECISION / excess if excess > 0 else 0.0

    def _in_band(self, material: Material, band: int, is_shooting: bool) -> float:
        """The camera sees the reference index where the paper's rays are not dispersed; photons always are."""
        if not is_shooting and not self.scene.paper.disperse_camera:
            return reference_ior(material)
        return ior_by_band(material, self.bands, self.scene.paper)[band]
