"""What modelling only what a scene requires saves, and what each required phenomenon costs and contributes.

Each scene is rendered by the tracer with everything on, with its plan, and with its plan less one required phenomenon
at a time. *Everything on* and *the plan* must be the same image: to the bit where nothing random differs, else within
the noise that the half images show.
"""

from __future__ import annotations

import json
import math
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy import stats

from vitrail.base.phenomenon import Phenomenon
from vitrail.engines.engine_build import engine_build
from vitrail.engines.tracer import Tracer
from vitrail.geometry.world import World
from vitrail.images.exr import ImageLayers, read_image
from vitrail.lower.tracer import lower_tracer
from vitrail.pipeline.queue import Progress, Work, run_tasks
from vitrail.pipeline.task import TIMEOUT_S, Row, Task
from vitrail.pipeline.task_log import TaskLog, read_rows
from vitrail.plan.analyse import analyse, everything
from vitrail.plan.budget import settings_for
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Quality, Settings
from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene
from vitrail.scene.print import scene_hash
from vitrail.study.tradeoff.removal import HOW, without

REPEATS = 5
"""Runs of the plan and of everything on, in turns, so that other work on the machine slows both alike."""

REPEATS_WITHOUT = 2
"""Runs of the plan less one phenomenon."""

PIXELS = 64 * 64
PHOTONS = 50_000
FINAL_GATHER_RAYS = 4
"""Every scene is rendered so small that all of them take minutes; the wishes of the scene are kept."""

SLOWER = 0.01
"""Chance of calling one of all scenes slower with its plan when none is."""

Variant = str
EVERYTHING, PLANNED = "everything", "plan"


def run_plan_study(
    scenes: Sequence[Loaded],
    out: Path,
    *,
    jobs: int = 1,
    report: Callable[[Progress], None] = lambda progress: None,
) -> dict[str, Any]:
    """Measure what is missing in ``out``, write plans.json; returns its content."""
    tasks = [_task(loaded) for loaded in scenes]
    by_hash = {scene_hash(loaded.scene): loaded for loaded in scenes}
    work: dict[str, Work] = {"variants": lambda spec: _measure(by_hash[spec["scene"]], spec)}
    rows = run_tasks(tasks, TaskLog(out), work, jobs=jobs, report=report)
    return _write(out, analyse_plans(rows))


def analyse_plan_folder(out: Path) -> dict[str, Any]:
    """Analyse the stored samples again, without rendering. Raises FileNotFoundError before the study has finished."""
    return _write(out, analyse_plans(read_rows(out)))


def _write(out: Path, found: dict[str, Any]) -> dict[str, Any]:
    (out / "plans.json").write_text(json.dumps(found, indent=1, sort_keys=True, allow_nan=False) + "\n")
    return found


def _task(loaded: Loaded) -> Task:
    """One task a scene, because its variants are compared with each other."""
    limits = {"pixels": PIXELS, "photons": PHOTONS, "final_gather_rays": FINAL_GATHER_RAYS, "repeats": REPEATS}
    spec = {"scene": scene_hash(loaded.scene), "name": loaded.path.stem, "build": engine_build("tracer"), **limits}
    return Task("variants", spec)


def _measure(loaded: Loaded, spec: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Render every variant, and compare each with the plan's image."""
    scene = _small(loaded.scene, int(spec["pixels"]))
    world = World.of_scene(scene)
    plan = analyse(world)
    settings = _settings(scene, plan, spec)
    required = [phenomenon for phenomenon in Phenomenon if plan.requires(phenomenon)]
    images: dict[Variant, ImageLayers] = {}
    costs: dict[str, list[float]] = {}
    for _ in range(int(spec["repeats"])):
        for name, variant in ((PLANNED, plan), (EVERYTHING, everything(world))):
            images[name], seconds = _render(loaded, scene, variant, settings)
            costs.setdefault(name, []).append(seconds)
    for phenomenon in required:
        for _ in range(REPEATS_WITHOUT):
            images[phenomenon.value], seconds = _render(loaded, *without(scene, plan, phenomenon), settings)
            costs.setdefault(phenomenon.value, []).append(seconds)
    differences = {name: _difference(image, images[PLANNED]) for name, image in images.items() if name != PLANNED}
    return {"required": [phenomenon.value for phenomenon in required], "differences": differences}, {"cpu_s": costs}


def _small(scene: Scene, pixels: int) -> Scene:
    """The scene with at most ``pixels`` pixels, of the same shape."""
    width, height = scene.image.width, scene.image.height
    shrink = min(1.0, math.sqrt(pixels / (width * height)))
    size = {"width": max(1, round(width * shrink)), "height": max(1, round(height * shrink))}
    return scene.model_copy(update={"image": scene.image.model_copy(update=size)})


def _settings(scene: Scene, plan: Plan, spec: Mapping[str, Any]) -> Settings:
    """Those of the plan in every variant: only the phenomena differ."""
    world = World.of_scene(scene)
    settings = settings_for(world, plan, Quality.DRAFT)
    fewer = {"photons": min(settings.photons, int(spec["photons"]))}
    if settings.final_gather_rays:
        fewer["final_gather_rays"] = int(spec["final_gather_rays"])
    return settings_for(world, plan, Quality.DRAFT, **fewer)


def _render(loaded: Loaded, scene: Scene, plan: Plan, settings: Settings) -> tuple[ImageLayers, float]:
    lowered = lower_tracer(World.of(loaded).with_scene(scene), plan, settings)
    with tempfile.TemporaryDirectory(prefix="vitrail-plan-") as folder:
        rendering = Tracer(timeout_s=TIMEOUT_S).render(lowered, Path(folder), threads=1)
        return read_image(rendering.image_path), float(rendering.record["process"]["cpu_s"])


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


# --- analysis -------------------------------------------------------------------------------------------------------


def analyse_plans(rows: Sequence[Row]) -> dict[str, Any]:
    """The record of all scenes, from their rows alone."""
    scenes = [_scene_record(row, len(rows)) for row in rows]
    kept = [scene for scene in scenes if scene["failure"] is None]
    total = {name: math.fsum(scene["cpu_s"][name] for scene in kept) for name in (EVERYTHING, PLANNED)}
    summary = {
        "scenes": len(scenes),
        "same_bits": sum(scene["differences"][EVERYTHING]["same_bits"] for scene in kept),
        "slower": [scene["name"] for scene in kept if scene["slower"]],
        "cpu_s": total,
    }
    return {
        "vitrail_plans": 2,
        "scenes": scenes,
        "summary": summary,
        "removed": {phenomenon.value: words for phenomenon, words in HOW.items()},
    }


def _scene_record(row: Row, suite: int) -> dict[str, Any]:
    runs: Mapping[str, Any] = row.cost.get("cpu_s", {})
    return {
        "name": row.spec["name"],
        "failure": row.failure,
        "cpu_s": {name: min(seconds) for name, seconds in runs.items()},
        "runs_cpu_s": {name: runs[name] for name in (EVERYTHING, PLANNED) if name in runs},
        "slower": bool(runs) and _is_slower(runs[PLANNED], runs[EVERYTHING], SLOWER / suite),
        **(row.result or {}),
    }


def _is_slower(planned: Sequence[float], whole: Sequence[float], level: float) -> bool:
    """Whether the plan took more CPU seconds than everything on, beyond the scatter of the runs (Welch's t test)."""
    return bool(stats.ttest_ind(planned, whole, equal_var=False, alternative="greater").pvalue < level)
