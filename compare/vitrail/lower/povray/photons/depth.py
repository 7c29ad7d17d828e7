"""How deep POV-Ray traces: one counter for what the scene counts apart.

POV-Ray answers black beyond ``max_trace_level``; a level is a face crossed or mirrored at, plus one for what is seen at
the end [P 4.3, 2.7]. The scene limits reflections and transmissions separately, so their sum is the level; where
nothing mirrors but totally, which counts as a transmission, both count alike.
"""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.lower.povray.asked import Asked
from vitrail.plan.settings import Quality
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.model import Material

DEEPEST = 176
"""Levels that POV-Ray's stack holds: at 230 it ends with a segmentation fault, though it takes 256 [P 4.3, 7]."""
DEEPEST_OF_PARTS = 128
"""The same for photons, and where glass scatters, glows or absorbs, which take more of the stack: it ends at 170."""
ADC_BAILOUT: dict[Quality, float] = {Quality.DRAFT: 1e-3, Quality.NORMAL: 1e-4, Quality.REFERENCE: 1e-6}
"""Path weight below which POV-Ray gives up; its default of 1/255 turns glass black [P 4.3].

Measured on a glass of wine against 1e-6: 1e-3 loses 7e-5 of the picture's light, 1e-4 loses 2e-5 in a ninth of the
time.
"""
MARGIN = 2
"""Levels beyond a proven chain, so that a path that uses them all shows an error."""


@dataclass(frozen=True)
class TraceDepth:
    """``level`` for the scene; ``wanted`` before POV-Ray's ``limit``; proven chains leave levels unused.

    Branches of a path lighter than ``adc_bailout`` are cut.
    """

    level: int
    wanted: int
    limit: int
    is_proven: bool
    adc_bailout: float


def trace_depth(asked: Asked) -> TraceDepth:
    chain = asked.plan.chain
    wanted = chain.reflections + chain.transmissions + (MARGIN if chain.proven else 1)
    in_parts = asked.has_caustic or any(map(_has_parts, asked.scene.materials.values()))
    limit = DEEPEST_OF_PARTS if in_parts else DEEPEST
    return TraceDepth(min(wanted, limit), wanted, limit, chain.proven, ADC_BAILOUT[asked.settings.quality])


def _has_parts(material: Material) -> bool:
    has_more = material.is_diffuse or material.emission is not None or max(absorption_per_m(material)) > 0
    return material.is_specular and has_more
