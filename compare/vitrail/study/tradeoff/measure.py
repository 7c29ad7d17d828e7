"""The work of one task: one engine, one setting, one seed; its errors against the truth, and its price."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from vitrail.engines.base import Rendering
from vitrail.engines.povray import Povray
from vitrail.engines.tracer import Tracer
from vitrail.images.exr import read_image
from vitrail.judge.comparison import Pair
from vitrail.judge.observe import Observed, observe
from vitrail.judge.references import SceneTruth
from vitrail.judge.verdict import Measured
from vitrail.lower.povray import lower_povray
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import Loaded
from vitrail.scene.model import Transport

PAIRS = {"tracer": Pair.TRACER_TRUTH, "povray": Pair.POVRAY_TRUTH}


class Measure:
    """Renders a scene at given knobs and holds it against its truth."""

    def __init__(self, loaded: Loaded, truth: SceneTruth) -> None:
        self._loaded, self._truth = loaded, truth

    def __call__(self, spec: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, float]]:
        """``spec`` as made by ``study.tradeoff.run``; returns errors by observation and the cost."""
        loaded = self._with_transport(spec["transport"])
        with tempfile.TemporaryDirectory(prefix="vitrail-tradeoff-") as folder:
            rendering, radius_m = _rendered(spec, loaded, Path(folder))
            image = read_image(rendering.image_path)
        pair = PAIRS[spec["engine"]]
        observed = observe(loaded.scene, {spec["engine"]: image}, (pair,), self._truth, radius_m)
        return {"errors": [error for entry in observed for error in _errors(entry)]}, _cost(rendering)

    def _with_transport(self, changes: Mapping[str, Any]) -> Loaded:
        """The scene with some of its transport wishes replaced."""
        if not changes:
            return self._loaded
        scene = self._loaded.scene
        transport = Transport.model_validate({**scene.transport.model_dump(), **changes})
        return replace(self._loaded, scene=scene.model_copy(update={"transport": transport}))


def _rendered(spec: Mapping[str, Any], loaded: Loaded, folder: Path) -> tuple[Rendering, float]:
    """One thread, so that CPU seconds are those of the work and not of waiting."""
    plan = analyse(loaded.scene)
    settings = settings_for(loaded.scene, plan, "normal", **spec["settings"], seed=spec["seed"])
    if spec["engine"] == "tracer":
        lowered = lower_tracer(loaded.scene, plan, settings, loaded.path.parent.resolve())
        return Tracer().render(lowered, folder, threads=1), settings.gather_radius_m
    return Povray().render(lower_povray(loaded.scene, plan, settings, loaded), folder, threads=1), (
        settings.gather_radius_m
    )


def _cost(rendering: Rendering) -> dict[str, float]:
    """CPU seconds and peak memory of the engine's own process."""
    record = rendering.record
    process = record.get("process", {})
    return {
        "cpu_s": float(process.get("cpu_s", record["cpu_s"]["total"])),
        "peak_memory_bytes": float(process.get("peak_memory_bytes", record["peak_memory_bytes"])),
    }


def _errors(observed: Observed) -> list[dict[str, Any]]:
    return [
        {
            "observation": observed.observation.name,
            "phenomenon": observed.observation.phenomenon.value,
            "metric": measured.metric,
            "error": (measured.value - measured.ideal) / _scale(measured, observed),
            "standard_error": measured.noise.standard_error / _scale(measured, observed),
        }
        for measured in observed.measured
        if math.isfinite(measured.value)
    ]


def _scale(measured: Measured, observed: Observed) -> float:
    """What an error is relative to: the true value, or the patch's half edge for a place, or 1."""
    if measured.ideal != 0:
        return abs(measured.ideal)
    return observed.half_edge_m if measured.unit == "m" else 1.0
