"""Lower one job for both engines, with the known mistake that was asked for already in."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from vitrail.base.engine_name import EngineName
from vitrail.lower.povray import PovrayScene
from vitrail.lower.povray.certificate.certificate import Certificate
from vitrail.pipeline.job import Job
from vitrail.pipeline.request import Request
from vitrail.scene.print import scene_hash


@dataclass(frozen=True)
class Lowered:
    """One scene in the two forms that the engines take; POV-Ray's is None where nobody asks for it."""

    tracer: dict[str, Any]
    povray: PovrayScene | None

    @property
    def certificate(self) -> Certificate:
        """What the translation changes; nothing where there is none."""
        return self.povray.certificate if self.povray is not None else Certificate(())


def lower(job: Job, request: Request) -> Lowered:
    """The tracer's form, and POV-Ray's if the request wants it.

    Raises NotTranslatable with the scene's lines, and NothingToEdit where the request's defect changes nothing.
    """
    defect, scene = request.defect, job.scene
    tracer = job.with_scene(defect.misread_by_tracer(scene)).lowered(EngineName.TRACER)
    # A misread scene is still meant to be this one: both images carry its hash.
    tracer["scene_hash"] = scene_hash(scene)
    if "povray" not in request.against:
        return Lowered(defect.tracer(tracer), None)
    povray = job.with_scene(defect.misread_by_povray(scene)).lowered(EngineName.POVRAY)
    povray = replace(povray, scene_hash=scene_hash(scene))
    return Lowered(defect.tracer(tracer), defect.povray(povray))
