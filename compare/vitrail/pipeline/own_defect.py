"""A defect of this program met in one scene: it is the end of that scene, with its traceback kept, and of no other."""

from __future__ import annotations

import traceback
from collections.abc import Callable
from typing import TypeVar

from vitrail.base.disk_error import is_disk_error
from vitrail.images.exr import ImageError
from vitrail.judge.records import SceneResult, Status
from vitrail.judge.reference_files import ReferencesError
from vitrail.judge.thresholds import ThresholdError
from vitrail.pipeline.request import Request
from vitrail.pipeline.scene_record import ended, record_of_scene, reproduce
from vitrail.pipeline.scene_run import SceneTask
from vitrail.scene.diagnostic import SceneErrors

T = TypeVar("T")

TRACEBACK = "traceback.txt"
"""The file beside a scene's results that says where the program failed."""


def is_own_defect(error: Exception) -> bool:
    """Whether nobody but this program is to blame: neither a scene, a reference, an image nor a place on disk."""
    if isinstance(error, OSError):
        return not is_disk_error(error)
    return not isinstance(error, SceneErrors | ReferencesError | ThresholdError | ImageError)


def if_own_defect(work: Callable[[], T], instead: Callable[[Exception], T]) -> T:
    """What ``work`` gives, or where this program itself is at fault what ``instead`` makes of the error."""
    try:
        return work()
    except Exception as error:
        if not is_own_defect(error):
            raise
        return instead(error)


def defective(task: SceneTask, error: Exception) -> SceneResult:
    """The record of a scene that met ``error``, whose traceback is written beside its results. Raises OSError."""
    place = keep_traceback(task.name, task.request, error)
    message = f"{_told(error)}; its traceback is in {place}, report it with the scene"
    again = reproduce(task.loaded.path, task.request.quality, task.request)
    return ended(record_of_scene(task.loaded, task.name, again), Status.DEFECT, message)


def unsearched(record: SceneResult, request: Request, error: Exception) -> str:
    """The remark on a judged scene whose deviation could not be looked for; its verdict stands. Raises OSError."""
    place = keep_traceback(record.name, request, error)
    return f"where it deviates was not found: {_told(error)}; its traceback is in {place}, report it with the scene"


def keep_traceback(name: str, request: Request, error: Exception) -> str:
    """Write the traceback into the scene's folder; returns its path relative to that of ``results.json``."""
    place = request.out / name / TRACEBACK
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text("".join(traceback.format_exception(error)), encoding="utf-8")
    return f"{name}/{TRACEBACK}"


def _told(error: Exception) -> str:
    words = " ".join(str(error).split())
    return f"a defect of Vitrail itself: {type(error).__name__}{': ' if words else ''}{words}"
