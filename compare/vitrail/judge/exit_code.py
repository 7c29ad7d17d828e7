"""What a scene's result means to the caller of the program.

Incomplete work outranks any verdict, because a verdict on half of the evidence is none: a defect of this program, then
a scene that could not be read, an engine that failed, a scene that cannot be translated, a deviation, doubt.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import assert_never

from vitrail.judge.comparison import Verdict
from vitrail.judge.records import Status

AGREES, DEVIATES, SCENE_ERROR, NOT_TRANSLATABLE, ENGINE_FAILED, INCONCLUSIVE = range(6)
DEFECT, INTERRUPTED = 70, 130

RANK = (INTERRUPTED, DEFECT, SCENE_ERROR, ENGINE_FAILED, NOT_TRANSLATABLE, DEVIATES, INCONCLUSIVE, AGREES)


def of_verdict(verdict: Verdict | None) -> int:
    """The exit code of a verdict; a judged scene with nothing to judge is an error of the scene."""
    match verdict:
        case Verdict.AGREES:
            return AGREES
        case Verdict.DEVIATES:
            return DEVIATES
        case Verdict.INCONCLUSIVE:
            return INCONCLUSIVE
        case None:
            return SCENE_ERROR
        case _:
            assert_never(verdict)


def of_scene(status: Status, verdict: Verdict | None) -> int:
    """The exit code of one scene."""
    match status:
        case Status.JUDGED:
            return of_verdict(verdict)
        case Status.SCENE_ERROR | Status.GATE_FAILED:
            return SCENE_ERROR
        case Status.NOT_TRANSLATABLE:
            return NOT_TRANSLATABLE
        case Status.ENGINE_FAILED:
            return ENGINE_FAILED
        case Status.DEFECT:
            return DEFECT
        case Status.INTERRUPTED:
            return INTERRUPTED
        case _:
            assert_never(status)


def of_run(codes: Iterable[int]) -> int:
    """The exit code of a run is that of its worst scene; a run without scenes is an error of use."""
    found = set(codes)
    return next((code for code in RANK if code in found), SCENE_ERROR)
