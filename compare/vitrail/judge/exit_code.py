"""What a scene's result means to the caller of the program.

Incomplete work outranks any verdict, because a verdict on half of the evidence is none: a defect of this program, then
a scene that could not be read, an engine that failed, a scene that cannot be translated, a deviation, doubt.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import assert_never

from vitrail.base.exit_code import ExitCode
from vitrail.judge.comparison import Verdict
from vitrail.judge.records import Status

RANK = (
    ExitCode.INTERRUPTED,
    ExitCode.DEFECT,
    ExitCode.SCENE_ERROR,
    ExitCode.ENGINE_FAILED,
    ExitCode.NOT_TRANSLATABLE,
    ExitCode.DEVIATES,
    ExitCode.INCONCLUSIVE,
    ExitCode.AGREES,
)


def of_verdict(verdict: Verdict | None) -> ExitCode:
    """The exit code of a verdict; a judged scene with nothing to judge is an error of the scene."""
    match verdict:
        case Verdict.AGREES:
            return ExitCode.AGREES
        case Verdict.DEVIATES:
            return ExitCode.DEVIATES
        case Verdict.INCONCLUSIVE:
            return ExitCode.INCONCLUSIVE
        case None:
            return ExitCode.SCENE_ERROR
        case _:
            assert_never(verdict)


def of_scene(status: Status, verdict: Verdict | None) -> ExitCode:
    """The exit code of one scene."""
    match status:
        case Status.JUDGED:
            return of_verdict(verdict)
        case Status.SCENE_ERROR | Status.GATE_FAILED:
            return ExitCode.SCENE_ERROR
        case Status.NOT_TRANSLATABLE:
            return ExitCode.NOT_TRANSLATABLE
        case Status.ENGINE_FAILED:
            return ExitCode.ENGINE_FAILED
        case Status.DEFECT:
            return ExitCode.DEFECT
        case Status.INTERRUPTED:
            return ExitCode.INTERRUPTED
        case _:
            assert_never(status)


def of_run(codes: Iterable[int]) -> ExitCode:
    """The exit code of a run is that of its worst scene; a run without scenes is an error of use."""
    found = set(codes)
    return next((code for code in RANK if code in found), ExitCode.SCENE_ERROR)
