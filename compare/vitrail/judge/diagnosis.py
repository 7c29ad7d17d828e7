"""Which phenomenon is broken, when several deviate: the most basic one, because the others rest on it.

A wrong light moves every caustic, a wrong index every spectrum. So phenomena are ordered by what they are made of, and
the first in that order that deviates is named; the engine is the one that closed forms call wrong.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from vitrail.judge.comparison import Cause, ObservationResult, Verdict
from vitrail.judge.records import SceneResult
from vitrail.scene.phenomenon import Phenomenon

BASIC_FIRST = (
    Phenomenon.DIFFUSION,
    Phenomenon.SHADOW,
    Phenomenon.INDIRECT_LIGHT,
    Phenomenon.REFLECTION,
    Phenomenon.REFRACTION,
    Phenomenon.TOTAL_INTERNAL_REFLECTION,
    Phenomenon.COLOURED_TRANSMISSION,
    Phenomenon.ABSORPTION,
    Phenomenon.ROUGHNESS,
    Phenomenon.DISPERSION,
    Phenomenon.CAUSTIC,
)


@dataclass(frozen=True)
class Diagnosis:
    """What deviates at all, the phenomenon that explains the rest, and the engine that is wrong where truth tells."""

    phenomenon: Phenomenon | None
    engine: str | None
    deviating: tuple[Phenomenon, ...]


def diagnose(scenes: Iterable[SceneResult]) -> Diagnosis:
    """Name one phenomenon and one engine for everything that deviates in a run."""
    observations = [entry for scene in scenes for entry in scene.observations if entry.verdict is Verdict.DEVIATES]
    deviating = tuple(phenomenon for phenomenon in BASIC_FIRST if any(o.phenomenon is phenomenon for o in observations))
    if not deviating:
        return Diagnosis(None, None, ())
    return Diagnosis(deviating[0], _engine(o for o in observations if o.phenomenon is deviating[0]), deviating)


def _engine(observations: Iterable[ObservationResult]) -> str | None:
    """The engine that closed forms call wrong most often; None where no closed form tells."""
    named = [
        comparison.attribution.engine
        for observation in observations
        for comparison in observation.comparisons
        if comparison.verdict is Verdict.DEVIATES
        and comparison.attribution is not None
        and comparison.attribution.cause is Cause.MODEL
        and comparison.attribution.engine is not None
    ]
    return max(sorted(set(named)), key=named.count) if named else None
