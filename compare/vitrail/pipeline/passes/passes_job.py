"""What is to be made from passes: a job, where its image goes, and which numbers of it count."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from vitrail.base.engine_name import EngineName
from vitrail.engines.base import Engine
from vitrail.engines.engine_build import build_of
from vitrail.judge.half_error import Observer
from vitrail.judge.references import SceneTruth
from vitrail.judge.thresholds import Thresholds
from vitrail.pipeline.content_keys import tracer_key
from vitrail.pipeline.job import Job
from vitrail.pipeline.passes.checkpoint import Identity


@dataclass(frozen=True)
class PassesJob:
    """One image to be made from passes of ``job``. ``truth`` and ``thresholds`` say which numbers of an observation
    count, and relative to what."""

    job: Job
    out: Path
    truth: SceneTruth
    thresholds: Thresholds
    engine: Engine
    threads: int = 0

    @cached_property
    def lowered(self) -> dict[str, Any]:
        """The tracer's input for the first pass."""
        return self.job.lowered(EngineName.TRACER)

    @property
    def first_radius_m(self) -> float:
        """Gather radius of the first pass, the largest."""
        return self.job.settings.gather_radius_m

    @cached_property
    def observer(self) -> Observer:
        """What measures the errors of the observed numbers."""
        return Observer(self.job.scene, self.truth, self.thresholds, self.first_radius_m)

    @property
    def identity(self) -> Identity:
        """What decides the bits of every pass."""
        build = build_of(self.engine)
        settings = self.lowered["settings"]
        return Identity(tracer_key(build, self.lowered), self.lowered["scene_hash"], settings, build)
