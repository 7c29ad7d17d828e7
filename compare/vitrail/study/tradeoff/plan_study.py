"""What modelling only what a scene requires saves, and what each required phenomenon costs and contributes.

Each scene is rendered by the tracer with everything on, with its plan, and with its plan less one required phenomenon
at a time. *Everything on* and *the plan* must be the same image: to the bit where nothing random differs, else within
the noise that the half images show.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from vitrail.engines.tracer import Tracer
from vitrail.images.exr import ImageLayers, read_image
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import analyse, everything
from vitrail.plan.budget import settings_for
from vitrail.plan.plan import Plan, Requirement
from vitrail.scene.load import Loaded
from vitrail.scene.phenomenon import Phenomenon
from vitrail.scene.print import scene_hash
from vitrail.study.queue import Progress, run_tasks
from vitrail.study.task import Row, Task
from vitrail.study.task_log import TaskLog

REPEATS = 3
"""The plan and everything on are held against each other in time, so each is the least of three runs: other work on
the machine only ever adds to CPU seconds. The plans less one phenomenon are run once."""

Variant = str
EVERYTHING, PLANNED = "everything", "plan"


def run_plan_study(
    scenes: Sequence[Loaded],
    out: Path,
    *,
    quality: str = "draft",
    jobs: int = 1,
    report: Callable[[Progress], None] = lambda progress: None,
) -> dict[str, Any]:
    """Measure what is missing in ``out``, write plans.json; returns its content."""
    tasks = [task for loaded in scenes for task in _tasks(loaded, quality)]
    by_hash = {scene_hash(loaded.scene): loaded for loaded in scenes}
    rows = run_tasks(
        tasks, TaskLog(out), {"variants": lambda spec: _measure(by_hash[spec["scene"]], spec)}, jobs=jobs, report=report
    )
    found = {"vitrail_plans": 1, "scenes": [_scene_record(row) for row in rows]}
    (out / "plans.json").write_text(json.dumps(found, indent=1, sort_keys=True, allow_nan=False) + "\n")
    return found


def _tasks(loaded: Loaded, quality: str) -> list[Task]:
    """One task a scene, because its variants are compared with each other."""
    spec = {
        "scene": scene_hash(loaded.scene),
        "name": loaded.path.stem,
        "quality": quality,
        "version": Tracer().version(),
    }
    return [Task("variants", spec)]


def without(plan: Plan, phenomenon: Phenomenon) -> Plan:
    """The plan with one phenomenon taken out."""
    gone = Requirement(False, ("taken out by the study",), "none")
    return replace(plan, entries={**plan.entries, phenomenon: gone})


def _measure(loaded: Loaded, spec: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, float]]:
    """Render every variant, and compare each with the plan's image."""
    plan = analyse(loaded.scene)
    required = [phenomenon for phenomenon in Phenomenon if plan.requires(phenomenon)]
    variants: dict[Variant, Plan] = {PLANNED: plan, EVERYTHING: everything(loaded.scene)}
    variants |= {phenomenon.value: without(plan, phenomenon) for phenomenon in required}
    images, costs = {}, {}
    for name, variant in variants.items():
        repeats = REPEATS if name in (PLANNED, EVERYTHING) else 1
        images[name], costs[f"{name}_cpu_s"] = _render(loaded, plan, variant, str(spec["quality"]), repeats)
    differences = {name: _difference(image, images[PLANNED]) for name, image in images.items() if name != PLANNED}
    return {"required": [phenomenon.value for phenomenon in required], "differences": differences}, costs


def _render(loaded: Loaded, plan: Plan, variant: Plan, quality: str, repeats: int) -> tuple[ImageLayers, float]:
    """The settings are those of the plan in every variant: only the phenomena differ."""
    settings = settings_for(loaded.scene, plan, quality)  # type: ignore[arg-type]
    lowered = lower_tracer(loaded.scene, variant, settings, loaded.path.parent.resolve())
    seconds = []
    with tempfile.TemporaryDirectory(prefix="vitrail-plan-") as folder:
        for _ in range(repeats):
            rendering = Tracer().render(lowered, Path(folder), threads=1)
            seconds.append(float(rendering.record["process"]["cpu_s"]))
        return read_image(rendering.image_path), min(seconds)


def _difference(image: ImageLayers, planned: ImageLayers) -> dict[str, Any]:
    """Relative L1 difference, whether all bits are the same, and the difference in units of its own noise.

    ``sigmas`` is the root mean square over pixels of the difference over its standard error (1 if noise alone parts
    the images), where halves give a noise; null where they give none.
    """
    gap = image.radiance - planned.radiance
    total = float(np.abs(planned.radiance).sum())
    variance = _variance(image) + _variance(planned)
    noisy = variance > 0
    return {
        "relative_l1": float(np.abs(gap).sum()) / total if total > 0 else float(np.abs(gap).max()),
        "same_bits": bool(np.array_equal(image.radiance, planned.radiance)),
        "sigmas": float(np.sqrt((gap[noisy] ** 2).sum() / variance[noisy].sum())) if noisy.any() else None,
        "outside_noise": float(np.abs(gap[~noisy]).sum()) / total if total > 0 and (~noisy).any() else 0.0,
    }


def _variance(image: ImageLayers) -> np.ndarray:
    if image.variance is None:
        return np.zeros_like(image.radiance)
    return np.asarray(image.variance, float)


def _scene_record(row: Row) -> dict[str, Any]:
    cost = dict(row.cost)
    return {
        "name": row.spec["name"],
        "failure": row.failure,
        "cpu_s": {name.removesuffix("_cpu_s"): seconds for name, seconds in cost.items()},
        **(row.result or {}),
    }
