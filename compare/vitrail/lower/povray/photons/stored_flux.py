"""What POV-Ray keeps of a photon's flux: 8 bits, truncated, and the factor on all light that loses least of it.

One flux can be made exact: a factor gives it the mantissa 255 / 256. Several fluxes, such as those behind panes of
several tints, share one factor; the best of them leaves each a fraction of a step above what is kept [P 2.4].
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

from vitrail.lower.povray.photons.photons import Shooting, photon_flux
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.optics.dispersion import reference_ior
from vitrail.scene.model import Material

ONE_STEP = 1 / 128
"""Largest loss of a truncated 8-bit mantissa, at its low end; the mean over many fluxes is 0.27 %."""
ABOVE_THE_STEP = 1 + 2e-6
"""Lifts a flux over its truncation step by more than single precision may lower it."""
STEPS = 256
MOST_FLUXES = 16
"""More fluxes than that have no common factor worth looking for: each then loses what chance gives it."""
ALIKE = 9
"""Digits in which two fluxes are the same one."""


def main_fluxes(shooting: Shooting, exposure: Exposure, *, half: str) -> tuple[float, ...]:
    """Flux of a photon behind each specular object, by the shortest way through it, in a run of light factor 1.

    Each different one once, the largest first; units squared. With Fresnel it is that at normal incidence.
    """
    photons = shooting.photons
    found = {
        _rounded(photon_flux(source, ball, photons.spacing[half], strength) * path_share(glass, exposure))
        for source in shooting.lights
        if (strength := max(exposure.share(source.strength))) > 0
        for ball, glass in zip(photons.targets, shooting.specular, strict=True)
    }
    return tuple(sorted(found - {0.0}, reverse=True))


def fluxes_to_keep(shooting: Shooting, exposure: Exposure) -> tuple[float, ...]:
    """The fluxes that the light factor of a run should keep: its own half's where there are several.

    A single one is that of the first half; the spacing of the second keeps it exact there too.
    """
    first = main_fluxes(shooting, exposure, half="a")
    return first if len(first) <= 1 else main_fluxes(shooting, exposure, half=exposure.half)


def largest_loss(shooting: Shooting, exposures: Sequence[Exposure]) -> float:
    """What storing cuts off photons behind one specular object at most, in the runs of both halves."""
    worst = 0.0
    for exposure in (replace(each, half=half) for each in exposures for half in shooting.photons.spacing):
        fluxes = fluxes_to_keep(shooting, exposure)
        if len(fluxes) > MOST_FLUXES:
            return ONE_STEP
        if len(fluxes) > 1:
            worst = max(worst, best_mantissa_factor(fluxes)[1])
    return worst


def path_share(material: Material, exposure: Exposure) -> float:
    """What the shortest way leaves of a photon: t^2 through glass, r of a mirror; 1 where that is nothing."""
    r, t = max(exposure.share(material.reflection)), max(exposure.share(material.transmission))
    if material.fresnel and material.is_transmissive:
        index = reference_ior(material)
        return ((r + t) * 4 * index / (index + 1) ** 2) ** 2 or 1.0
    return (t**2 if material.is_transmissive else r) or 1.0


def _rounded(flux: float) -> float:
    """The same number for all fluxes that are the same but for rounding."""
    return float(f"{flux:.{ALIKE}g}")


def stored_loss(flux: float) -> float:
    """The share of a flux above 0 that storing it cuts off."""
    mantissa = math.frexp(flux)[0] * STEPS
    return 1 - math.floor(mantissa) / mantissa


def best_mantissa_factor(fluxes: Sequence[float]) -> tuple[float, float]:
    """A factor in [1, 2) and the largest loss it leaves any of the fluxes: (factor, loss).

    The best one puts one of them just above a step, for between such places every loss grows; so those are tried.
    """
    return min(((factor, worst_loss(fluxes, factor)) for factor in _candidates(fluxes)), key=lambda found: found[1])


def worst_loss(fluxes: Iterable[float], factor: float) -> float:
    """The largest loss among fluxes times a factor."""
    return max(stored_loss(flux * factor) for flux in fluxes)


def _candidates(fluxes: Sequence[float]) -> Iterable[float]:
    for flux in fluxes:
        mantissa = math.frexp(flux)[0]
        # From the largest mantissa down: where several are as good, steps are smallest at the top.
        for step in range(STEPS - 1, STEPS // 2 - 1, -1):
            factor = step / STEPS / mantissa * ABOVE_THE_STEP
            yield factor if factor >= 1 else 2 * factor
