"""The work of one task: one engine, one setting, one seed; its errors against the truth, and its price."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.base.engine_name import EngineName
from vitrail.base.record import JsonObject
from vitrail.engines.base import Rendering
from vitrail.engines.installed import engine_named
from vitrail.images.exr import ImageLayers, read_image
from vitrail.judge.comparison import Pair
from vitrail.judge.observe import Observed, observe
from vitrail.judge.references import SceneTruth
from vitrail.judge.verdict import Measured
from vitrail.pipeline.job import prepare
from vitrail.pipeline.run import run
from vitrail.pipeline.task import TIMEOUT_S
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene, Transport
from vitrail.study.tradeoff.converged import Converged
from vitrail.study.tradeoff.knobs import KnobValue
from vitrail.study.tradeoff.records import Errors, MeasuredError, RunCost

PAIRS = {"tracer": Pair.TRACER_TRUTH, "povray": Pair.POVRAY_TRUTH}
NOT_RELATIVE = ("delta_e_2000", "peak_difference")
"""Comparisons of two images that are no share of anything: a just visible difference of colour, a number of spots."""


class Measure:
    """Renders a scene at given knobs and holds it against its truth, or against the converged rendering."""

    def __init__(self, loaded: Loaded, truth: SceneTruth, converged: Converged | None = None) -> None:
        self._loaded, self._truth, self._converged = loaded, truth, converged

    def setting(self, spec: JsonObject) -> tuple[JsonObject, JsonObject]:
        """``spec`` as made by ``study.tradeoff.run``; returns errors by observation and the cost."""
        loaded = self._with_wishes(spec["wishes"])
        with tempfile.TemporaryDirectory(prefix="vitrail-tradeoff-") as folder:
            rendering, radius_m = _rendered(spec, loaded, Path(folder))
            image = read_image(rendering.image_path)
        errors = self._errors(loaded.scene, spec["engine"], image, radius_m)
        return errors.model_dump(mode="json"), _cost(rendering).model_dump(mode="json")

    def reference(self, spec: JsonObject) -> tuple[JsonObject, JsonObject]:
        """What the second of the converged renderings differs from the first: the reference's own error."""
        assert self._converged is not None
        radius_m = float(spec["settings"]["reference"]["gather_radius_m"])
        errors = self._errors(self._loaded.scene, "tracer", self._converged.image("second"), radius_m)
        return errors.model_dump(mode="json"), {}

    def _errors(self, scene: Scene, engine: str, image: ImageLayers, radius_m: float) -> Errors:
        """The errors of one image of ``scene`` by observation and metric."""
        if self._converged is None:
            observed = observe(scene, {engine: image}, (PAIRS[engine],), self._truth, radius_m)
        else:
            images = {"candidate": image, "reference": self._converged.image("reference")}
            observed = observe(scene, images, (Pair.CANDIDATE_REFERENCE,), SceneTruth(), radius_m)
        return Errors(errors=tuple(error for entry in observed for error in _errors(entry)))

    def _with_wishes(self, wishes: Mapping[str, KnobValue]) -> Loaded:
        """The scene with some of its wishes replaced."""
        if not wishes:
            return self._loaded
        scene, scale = self._loaded.scene, wishes.get("image_scale", 1)
        assert isinstance(scale, int)
        changes = {name: value for name, value in wishes.items() if name != "image_scale"}
        transport = Transport.model_validate({**scene.transport.model_dump(), **changes})
        size = {"width": scene.image.width * scale, "height": scene.image.height * scale}
        image = changed(scene.image, **size)
        return replace(self._loaded, scene=changed(scene, transport=transport, image=image))


def _rendered(spec: JsonObject, loaded: Loaded, folder: Path) -> tuple[Rendering, float]:
    """One thread, so that CPU seconds are those of the work and not of waiting."""
    job = prepare(loaded, Quality.NORMAL, {**spec["settings"], "seed": spec["seed"]})
    engine = engine_named(EngineName(spec["engine"]), timeout_s=TIMEOUT_S)
    return run(job, engine, folder, threads=1), job.settings.gather_radius_m


def _cost(rendering: Rendering) -> RunCost:
    """CPU seconds and peak memory of the engine's own process."""
    record = rendering.record
    process = record.get("process", {})
    return RunCost(
        cpu_s=process.get("cpu_s", record["cpu_s"]["total"]),
        peak_memory_bytes=max(process.get("peak_memory_bytes", 0), record["peak_memory_bytes"]),
    )


def _errors(observed: Observed) -> list[MeasuredError]:
    return [
        MeasuredError(
            observation=observed.observation.name,
            phenomenon=observed.observation.phenomenon,
            metric=measured.metric,
            error=(measured.value - measured.ideal) / _scale(measured, observed),
            standard_error=measured.noise.standard_error / _scale(measured, observed),
        )
        for measured in observed.measured
        if math.isfinite(measured.value) and measured.metric not in NOT_RELATIVE
    ]


def _scale(measured: Measured, observed: Observed) -> float:
    """What an error is relative to: the true value, or the patch's half edge for a place, or 1."""
    if measured.ideal != 0:
        return abs(measured.ideal)
    return observed.half_edge_m if measured.unit == "m" else 1.0
