"""Measure one value of one axis in one engine."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable
from pathlib import Path

from vitrail.base.engine_name import EngineName
from vitrail.engines.base import EngineFailure
from vitrail.engines.povray_text import render_text
from vitrail.engines.tracer import Tracer
from vitrail.images.exr import read_image
from vitrail.pipeline.job import Job, prepare
from vitrail.pipeline.run import run
from vitrail.pipeline.task import TIMEOUT_S
from vitrail.plan.analyse import everything
from vitrail.plan.settings import Quality
from vitrail.scene.load import load_text
from vitrail.study.extremes.axis import Axis
from vitrail.study.extremes.search import Reading

MOST_VERTICES = 1200
"""More than a path may have: 1000 transmissions and what it ends on."""


def probe_of(axis: Axis, engine: EngineName) -> Callable[[float], Reading]:
    """A probe for ``find_limit``; where the axis has no closed form, the first reading is the expected number."""
    measure = _MEASURES[engine]
    first: list[float] = []

    def probe(value: float) -> Reading:
        expected = axis.expected(value)
        try:
            measured, words = measure(axis, value), ""
        except EngineFailure as failure:
            # A refusal or a crash is a reading too: the range ends here, and the engine says why.
            measured, words = math.nan, str(failure)
        if math.isnan(expected):
            first.append(measured)
            expected = first[0]
        return Reading(value, measured, expected, axis.tolerance[engine].value, words)

    return probe


def _povray(axis: Axis, value: float) -> float:
    return axis.read(render_text(axis.sdl(value), axis.pixels, axis.pixels).radiance, value)


def _tracer(axis: Axis, value: float) -> float:
    job = _job(axis, value)
    if axis.ray is not None:
        ray = axis.ray(value)
        numbers = [",".join(map(repr, vector)) for vector in (ray.origin, ray.direction)]
        arguments = ["--origin", numbers[0], "--direction", numbers[1], "--branch", ray.branch]
        answer = Tracer().trace(job.lowered(EngineName.TRACER), [*arguments, "--max-vertices", str(MOST_VERTICES)])
        return ray.read(answer["vertices"])
    with tempfile.TemporaryDirectory(prefix="vitrail-atlas-") as folder:
        rendering = run(job, Tracer(timeout_s=TIMEOUT_S), Path(folder), threads=1)
        if axis.ledger is not None:
            return axis.ledger(rendering.record["ledger"])
        return axis.read(read_image(rendering.image_path).radiance, value)


def _job(axis: Axis, value: float) -> Job:
    """The scene with everything on, one sample per pixel."""
    loaded = load_text(axis.scene(value), f"{axis.name}.yaml")
    photons = {"photons": axis.photons} if axis.photons else {}
    return prepare(loaded, Quality.DRAFT, {"samples": 1, **photons}, planner=everything)


_MEASURES: dict[EngineName, Callable[[Axis, float], float]] = {EngineName.TRACER: _tracer, EngineName.POVRAY: _povray}
