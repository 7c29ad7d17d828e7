"""The decision about each phenomenon of the vocabulary."""

from __future__ import annotations

from typing import assert_never

from vitrail.base.phenomenon import Phenomenon
from vitrail.plan.evidence.angles import dispersion, roughness
from vitrail.plan.evidence.glass import absorption, coloured_transmission, refraction, total_internal_reflection
from vitrail.plan.evidence.light import caustic, indirect_light
from vitrail.plan.evidence.shadows import shadow
from vitrail.plan.evidence.surfaces import diffusion, reflection
from vitrail.plan.facts import Facts
from vitrail.plan.plan import Requirement


def requirement(phenomenon: Phenomenon, facts: Facts) -> Requirement:
    """Whether a scene requires a phenomenon, why, and what it costs."""
    match phenomenon:
        case Phenomenon.DIFFUSION:
            return diffusion(facts)
        case Phenomenon.REFLECTION:
            return reflection(facts)
        case Phenomenon.REFRACTION:
            return refraction(facts)
        case Phenomenon.TOTAL_INTERNAL_REFLECTION:
            return total_internal_reflection(facts)
        case Phenomenon.COLOURED_TRANSMISSION:
            return coloured_transmission(facts)
        case Phenomenon.ABSORPTION:
            return absorption(facts)
        case Phenomenon.CAUSTIC:
            return caustic(facts)
        case Phenomenon.ROUGHNESS:
            return roughness(facts)
        case Phenomenon.DISPERSION:
            return dispersion(facts)
        case Phenomenon.SHADOW:
            return shadow(facts)
        case Phenomenon.INDIRECT_LIGHT:
            return indirect_light(facts)
        case _:
            assert_never(phenomenon)
