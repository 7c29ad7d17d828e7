"""Which phenomenon is broken, when several deviate: the one seen in the plainest scene that fails.

A scene rests on everything that its plan requires, so a wrong index spoils every caustic too. A defect that shows in a
scene which requires little cannot lie in what that scene does not require; it is the best witness there is. Among
scenes that require as much, the phenomenon that the others are made of is named. The engine is the one that closed
forms call wrong.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import Cause, ObservationResult, Verdict
from vitrail.judge.records import SceneResult

BASIC_FIRST = (
    Phenomenon.DIFFUSION,
    Phenomenon.SHADOW,
    Phenomenon.INDIRECT_LIGHT,
    Phenomenon.REFLECTION,
    Phenomenon.REFRACTION,
    Phenomenon.COLOURED_TRANSMISSION,
    Phenomenon.ABSORPTION,
    Phenomenon.TOTAL_INTERNAL_REFLECTION,
    Phenomenon.ROUGHNESS,
    Phenomenon.DISPERSION,
    Phenomenon.CAUSTIC,
)
"""What acts at every face comes before what acts beyond an angle, and both before what is made of many rays."""


@dataclass(frozen=True)
class Diagnosis:
    """What deviates at all, the phenomenon that explains the rest, where it shows most plainly (scene and
    observation), and the engine that is wrong where truth tells."""

    phenomenon: Phenomenon | None
    engine: str | None
    deviating: tuple[Phenomenon, ...]
    scene: str = ""
    observation: str = ""


def diagnose(scenes: Iterable[SceneResult]) -> Diagnosis:
    """Name one phenomenon and one engine for everything that deviates in a run."""
    found = [(scene, entry) for scene in scenes for entry in scene.observations if entry.verdict is Verdict.DEVIATES]
    if not found:
        return Diagnosis(None, None, ())
    deviating = tuple(each for each in BASIC_FIRST if any(entry.phenomenon is each for _, entry in found))
    scene, witness = min(found, key=lambda each: (_demands(each[0]), BASIC_FIRST.index(each[1].phenomenon)))
    engine = _engine(entry for _, entry in found if entry.phenomenon is witness.phenomenon)
    return Diagnosis(witness.phenomenon, engine, deviating, scene.name, witness.name)


def _demands(scene: SceneResult) -> int:
    """How many phenomena the scene rests on."""
    return sum(entry.required for entry in scene.plan)


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
