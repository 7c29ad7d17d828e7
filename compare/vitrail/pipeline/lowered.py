"""The job of a request, lowered for both engines, with the known mistake that was asked for already in."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from vitrail.base.changed import changed
from vitrail.base.engine_name import EngineName
from vitrail.lower.povray import PovrayScene
from vitrail.lower.povray.certificate.certificate import Certificate
from vitrail.pipeline.job import Job, prepare
from vitrail.pipeline.request import Request
from vitrail.plan.views import ObservationView
from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene
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


def job_of(loaded: Loaded, request: Request) -> Job:
    """The job that a request makes of a scene. Raises the Fault of a setting that cannot be."""
    job = prepare(loaded, request.quality, request.overrides)
    return job.with_views(request.picture_width) if request.views else job


def lower(job: Job, request: Request) -> Lowered:
    """The tracer's form, and POV-Ray's if the request wants it.

    Raises NotTranslatable with the scene's lines, and NothingToEdit where the request's defect changes nothing.
    """
    defect = request.defect
    # The picture may be larger than the scene says, and the scene misread: the images are still meant to show it.
    meant = scene_hash(job.loaded.scene)
    tracer = _misread(job, defect.misread_by_tracer).lowered(EngineName.TRACER)
    tracer["scene_hash"] = meant
    if "povray" not in request.against:
        return Lowered(defect.tracer(tracer), None)
    povray = _misread(job, defect.misread_by_povray).lowered(EngineName.POVRAY)
    povray = replace(povray, scene_hash=meant)
    return Lowered(defect.tracer(tracer), defect.povray(povray))


def _misread(job: Job, misread: Callable[[Scene], Scene]) -> Job:
    """The job as one back end reads it: whoever misreads a camera misreads that of every view."""

    def view(meant: ObservationView) -> ObservationView:
        found = misread(changed(job.scene, camera=meant.camera, image=meant.image))
        return replace(meant, camera=found.camera, image=found.image)

    return replace(job.with_scene(misread(job.scene)), views=tuple(map(view, job.views)))
