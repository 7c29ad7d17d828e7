"""The factor on all light of a run: images near 1, and photons whose flux POV-Ray stores exactly.

Without photons it is a power of two, so that undoing it loses nothing, and what is a million times darker than the
brightest light still has all its digits. With photons it gives the flux of the main path
the mantissa 255 / 256, lifted a hair above, because storing truncates to 8 bits. From there a flux that varies can only
fall (Fresnel, absorption), and steps are smallest at the top. Where photons have several fluxes it is the factor that
cuts least off the worst of them, in each half for itself.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from vitrail.base.colour import Triplet
from vitrail.lower.povray.photons.photons import FLUX_LIMIT, photon_flux
from vitrail.lower.povray.photons.stored_flux import (
    ABOVE_THE_STEP,
    MOST_FLUXES,
    STEPS,
    best_mantissa_factor,
    fluxes_to_keep,
)
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.lights import Source
from vitrail.lower.povray.text.sky import BRIGHTEST
from vitrail.lower.povray.translation import Translation
from vitrail.scene.model import Checker, Material

HEADROOM = 64.0
"""How far above 1 the brightest light lies without photons: half floats keep 11 bits from 6e-5 to 65504, not below."""
MANTISSA = (STEPS - 1) / STEPS
"""The largest mantissa of 8 bits; 180 / 256, that of the second half, divides by the same step."""


def light_factor(translation: Translation, exposure: Exposure) -> float:
    """The factor for one run; no pixel of a sky times it is brighter than half floats hold.

    ``exposure.half`` is the half image whose photons it is for.
    """
    scene, shooting = translation.scene, translation.shooting(exposure.half)
    lights = translation.lighting.halves[exposure.half]
    pixel = max((max(exposure.share(sky.peak)) for sky in translation.lighting.skies.values()), default=0.0)
    brightest = max((max(exposure.share(source.strength)) * _nearness(source) for source in lights), default=0.0)
    glow = max((max(exposure.share(_peak(m))) for m in scene.materials.values() if m.emission is not None), default=0.0)
    peak = max(brightest, glow)
    if peak == 0:
        return 1.0
    factor = 2.0 ** round(-math.log2(peak))
    if shooting is None or brightest == 0:
        factor *= HEADROOM
        while factor * pixel > BRIGHTEST:
            factor /= 2
        return factor
    main = max(
        photon_flux(source, ball, shooting.photons.spacing["a"], max(exposure.share(source.strength)))
        for source in lights
        for ball in shooting.photons.targets
    )
    # Choose the power of two that changes the factor least and keeps the largest flux below the limit.
    exact = _exact_factor(fluxes_to_keep(shooting, exposure), main, factor)
    while main * exact > FLUX_LIMIT or pixel * exact > BRIGHTEST:
        exact /= 2
    return exact


def _exact_factor(fluxes: Sequence[float], main: float, near: float) -> float:
    """The factor nearest to ``near`` that makes one flux exact, or cuts least off several."""
    if 1 < len(fluxes) <= MOST_FLUXES:
        return near * best_mantissa_factor(fluxes)[0]
    stored = fluxes[0] if fluxes else main
    return 2.0 ** round(math.log2(stored * near)) * MANTISSA * ABOVE_THE_STEP / stored


def _nearness(source: Source) -> float:
    """Lamps count at ten units' distance, suns as they are."""
    return 1.0 if source.direction is not None else 0.01


def _peak(material: Material) -> Triplet:
    """The brightest emission of a material, checker or not."""
    emission = material.emission
    assert emission is not None
    if isinstance(emission, Checker):
        first, second = emission.checker.colors
        return (max(first[0], second[0]), max(first[1], second[1]), max(first[2], second[2]))
    return emission
