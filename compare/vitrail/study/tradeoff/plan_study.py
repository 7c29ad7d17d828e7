"""What modelling only what a scene requires saves, and what each required phenomenon costs and contributes.

Each scene is rendered by the tracer with everything on, with its plan, and with its plan less one required phenomenon
at a time. *Everything on* and *the plan* must be the same image: to the bit where nothing random differs, else within
the noise that the half images show.
"""

from __future__ import annotations

import math
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy import stats

from vitrail.base.changed import changed
from vitrail.base.engine_name import EngineName
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.progress import Progress, silent
from vitrail.base.record import JsonObject, write_record
from vitrail.engines.engine_build import engine_build
from vitrail.engines.tracer import Tracer
from vitrail.images.exr import ImageLayers, read_image
from vitrail.pipeline.campaign import Campaign, Work, run_campaign
from vitrail.pipeline.job import Job, prepare
from vitrail.pipeline.run import run
from vitrail.pipeline.task import TIMEOUT_S, Row, Task
from vitrail.pipeline.task_log import read_rows
from vitrail.plan.analyse import everything
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene
from vitrail.scene.print import scene_hash
from vitrail.study.tradeoff.plan_records import (
    EVERYTHING,
    PLANNED,
    ImageDifference,
    PlannedScene,
    Plans,
    PlanSummary,
    VariantCosts,
    Variants,
)
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


def run_plan_study(
    scenes: Sequence[Loaded],
    out: Path,
    *,
    jobs: int = 1,
    progress: Progress = silent,
) -> Plans:
    """Measure what is missing in ``out``, write plans.json; returns its content."""
    tasks = [_task(loaded) for loaded in scenes]
    by_hash = {scene_hash(loaded.scene): loaded for loaded in scenes}
    work: dict[str, Work] = {"variants": lambda spec: _measured(by_hash[spec["scene"]], spec)}
    rows = run_campaign(Campaign(tasks, work), out, jobs=jobs, progress=progress)
    return _write(out, analyse_plans(rows))


def analyse_plan_folder(out: Path) -> Plans:
    """Analyse the stored samples again, without rendering. Raises FileNotFoundError before the study has finished."""
    return _write(out, analyse_plans(read_rows(out)))


def _write(out: Path, found: Plans) -> Plans:
    write_record(found, out / "plans.json")
    return found


def _task(loaded: Loaded) -> Task:
    """One task a scene, because its variants are compared with each other."""
    limits = {"pixels": PIXELS, "photons": PHOTONS, "final_gather_rays": FINAL_GATHER_RAYS, "repeats": REPEATS}
    spec = {
        "scene": scene_hash(loaded.scene),
        "name": loaded.path.stem,
        "build": engine_build(EngineName.TRACER),
        **limits,
    }
    return Task("variants", spec)


def _measured(loaded: Loaded, spec: JsonObject) -> tuple[JsonObject, JsonObject]:
    """What a task leaves in the journal."""
    variants, costs = _variants(loaded, spec)
    return variants.model_dump(mode="json"), costs.model_dump(mode="json")


def _variants(loaded: Loaded, spec: JsonObject) -> tuple[Variants, VariantCosts]:
    """Render every variant, and compare each with the plan's image."""
    planned = _small_job(loaded, spec)
    whole = replace(planned, plan=everything(planned.world))
    required = [phenomenon for phenomenon in Phenomenon if planned.plan.requires(phenomenon)]
    images: dict[str, ImageLayers] = {}
    costs: dict[str, list[float]] = {}
    for _ in range(int(spec["repeats"])):
        for name, job in ((PLANNED, planned), (EVERYTHING, whole)):
            images[name], seconds = _render(job)
            costs.setdefault(name, []).append(seconds)
    for phenomenon in required:
        scene, plan = without(planned.scene, planned.plan, phenomenon)
        for _ in range(REPEATS_WITHOUT):
            images[phenomenon.value], seconds = _render(replace(planned.with_scene(scene), plan=plan))
            costs.setdefault(phenomenon.value, []).append(seconds)
    differences = {name: _difference(image, images[PLANNED]) for name, image in images.items() if name != PLANNED}
    runs = {name: tuple(seconds) for name, seconds in costs.items()}
    return Variants(required=tuple(required), differences=differences), VariantCosts(cpu_s=runs)


def _small(scene: Scene, pixels: int) -> Scene:
    """The scene with at most ``pixels`` pixels, of the same shape."""
    width, height = scene.image.width, scene.image.height
    shrink = min(1.0, math.sqrt(pixels / (width * height)))
    size = {"width": max(1, round(width * shrink)), "height": max(1, round(height * shrink))}
    return changed(scene, image=changed(scene.image, **size))


def _small_job(loaded: Loaded, spec: JsonObject) -> Job:
    """The small scene with its plan; every variant has its settings, so that only the phenomena differ."""
    small = replace(loaded, scene=_small(loaded.scene, int(spec["pixels"])))
    usual = prepare(small, Quality.DRAFT).settings
    fewer = {"photons": min(usual.photons, int(spec["photons"]))}
    if usual.final_gather_rays:
        fewer["final_gather_rays"] = int(spec["final_gather_rays"])
    return prepare(small, Quality.DRAFT, fewer)


def _render(job: Job) -> tuple[ImageLayers, float]:
    with tempfile.TemporaryDirectory(prefix="vitrail-plan-") as folder:
        rendering = run(job, Tracer(timeout_s=TIMEOUT_S), Path(folder), threads=1)
        return read_image(rendering.image_path), float(rendering.record["process"]["cpu_s"])


def _difference(image: ImageLayers, planned: ImageLayers) -> ImageDifference:
    """Relative L1 difference, whether all bits are the same, and the difference in units of its own noise."""
    gap = image.radiance - planned.radiance
    total = float(np.abs(planned.radiance).sum())
    variance = _variance(image) + _variance(planned)
    noisy = variance > 0
    return ImageDifference(
        relative_l1=float(np.abs(gap).sum()) / total if total > 0 else float(np.abs(gap).max()),
        same_bits=bool(np.array_equal(image.radiance, planned.radiance)),
        sigmas=float(np.sqrt((gap[noisy] ** 2).sum() / variance[noisy].sum())) if noisy.any() else None,
        outside_noise=float(np.abs(gap[~noisy]).sum()) / total if total > 0 and (~noisy).any() else 0.0,
    )


def _variance(image: ImageLayers) -> np.ndarray:
    if image.variance is None:
        return np.zeros_like(image.radiance)
    return np.asarray(image.variance, float)


# --- analysis -------------------------------------------------------------------------------------------------------


def analyse_plans(rows: Sequence[Row]) -> Plans:
    """The record of all scenes, from their rows alone."""
    scenes = tuple(_planned_scene(row, len(rows)) for row in rows)
    kept = [scene for scene in scenes if scene.failure is None]
    summary = PlanSummary(
        scenes=len(scenes),
        same_bits=sum(scene.differences[EVERYTHING].same_bits for scene in kept),
        slower=tuple(scene.name for scene in kept if scene.slower),
        cpu_s={name: math.fsum(scene.cpu_s[name] for scene in kept) for name in (EVERYTHING, PLANNED)},
    )
    return Plans(scenes=scenes, summary=summary, removed=HOW)


def _planned_scene(row: Row, suite: int) -> PlannedScene:
    """One scene of ``suite``; a failed one has neither times nor differences."""
    found = Variants.model_validate(row.result or {})
    runs = VariantCosts.model_validate(row.cost).cpu_s
    return PlannedScene(
        name=row.spec["name"],
        failure=row.failure,
        cpu_s={name: min(seconds) for name, seconds in runs.items()},
        runs_cpu_s={name: runs[name] for name in (EVERYTHING, PLANNED) if name in runs},
        slower=bool(runs) and _is_slower(runs[PLANNED], runs[EVERYTHING], SLOWER / suite),
        required=found.required,
        differences=found.differences,
    )


def _is_slower(planned: Sequence[float], whole: Sequence[float], level: float) -> bool:
    """Whether the plan took more CPU seconds than everything on, beyond the scatter of the runs (Welch's t test)."""
    return bool(stats.ttest_ind(planned, whole, equal_var=False, alternative="greater").pvalue < level)
