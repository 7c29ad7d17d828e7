"""A ball lens in a small picture, rendered by the real tracer in passes of a few photons."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from vitrail.check.check import check_file
from vitrail.engines.base import Engine
from vitrail.engines.tracer import Tracer
from vitrail.judge.references import SceneTruth, read_scene_truth
from vitrail.judge.thresholds import own_references, thresholds_of
from vitrail.pipeline.job import prepare
from vitrail.pipeline.passes.interrupt import Interrupt
from vitrail.pipeline.passes.passes_job import PassesJob
from vitrail.pipeline.passes.run import Finished, run_passes
from vitrail.pipeline.passes.stop import StopCriteria
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded, load_text
from vitrail.scene.model import Image

ROOT = Path(__file__).parents[3]

BALL = """
vitrail: 1
camera: {kind: orthographic, position: [0, 0, 2], look_at: [0, 0, 0], height: 1}
image: {width: 24, height: 24}
materials: {glow: {emission: 1}}
objects: [{name: ball, sphere: {center: [0, 0, 0], radius: 0.4}, material: glow}]
lights: []
observe: [{name: ball, phenomenon: diffusion, patch: {center: [0, 0, 0], u: [0.45, 0, 0], v: [0, 0.45, 0]}}]
"""
"""Nothing is random but where a pixel is looked through; the ball fills pi 0.4^2 / 0.9^2 of the patch."""


def ball_lens(pixels: int) -> Loaded:
    loaded = check_file(ROOT / "scenes" / "calibration" / "ball_lens.yaml").scene_or_raise()
    scene = loaded.scene.model_copy(update={"image": Image(width=pixels, height=pixels)})
    return replace(loaded, scene=scene)


def job(out: Path, pixels: int = 32, threads: int = 1, engine: Engine | None = None, **settings: Any) -> PassesJob:
    """``settings`` replace those of normal quality; 5000 photons and 4 samples unless they say otherwise."""
    loaded = ball_lens(pixels)
    truth = read_scene_truth(own_references(), "ball_lens", loaded.scene)
    return _job(loaded, truth, out, threads, engine, {"photons": 5000, "samples": 4, **settings})


def glowing_ball(out: Path, threads: int = 1, **settings: Any) -> PassesJob:
    return _job(load_text(BALL), SceneTruth(), out, threads, None, {"samples": 2, **settings})


def _job(
    loaded: Loaded, truth: SceneTruth, out: Path, threads: int, engine: Engine | None, settings: dict[str, Any]
) -> PassesJob:
    prepared = prepare(loaded, Quality.NORMAL, settings)
    return PassesJob(prepared, out, truth, thresholds_of(own_references()), engine or Tracer(), threads)


def passes(work: PassesJob, criteria: StopCriteria | int, *, resume: bool = False, **rest: Any) -> Finished:
    wanted = StopCriteria(criteria) if isinstance(criteria, int) else criteria
    return run_passes(work, wanted, Interrupt(), resume=resume, **rest)
