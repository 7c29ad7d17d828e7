"""From the runs of POV-Ray to one layered image a view and one run record."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from vitrail.base.canonical_json import canonical_json
from vitrail.base.whole_file import whole_file, write_whole
from vitrail.engines.base import Rendering
from vitrail.engines.child import Finished
from vitrail.engines.povray_output import Statistics
from vitrail.images.exr import write_image
from vitrail.lower.povray import PovrayRun, PovrayScene

NOTICEABLE_LOSS = 0.01
"""Share of a look that cut branches may take before the run record warns of it."""


@dataclass(frozen=True)
class Execution:
    """POV-Ray started and ended once."""

    finished: Finished
    output: str
    statistics: Statistics
    walls: tuple[str, ...]


@dataclass(frozen=True)
class PhotonCensus:
    """The execution that shot the photons of a run, how many it stored, their flux, and our time to order them."""

    shot: Execution
    stored: int
    flux: np.ndarray
    order_cpu_s: float


@dataclass(frozen=True)
class Drawn:
    """The picture of one view, (height, width, 3), and the execution that drew it; the scene's own has no name."""

    view: str
    image: np.ndarray
    done: Execution


@dataclass(frozen=True)
class Outcome:
    """One finished run with its pictures; a repeated one took them from a run with the same texts."""

    run: PovrayRun
    drawn: tuple[Drawn, ...]
    census: PhotonCensus | None
    is_repeated: bool = False

    @property
    def executions(self) -> list[Execution]:
        pictures = [each.done for each in self.drawn]
        return [self.census.shot, *pictures] if self.census else pictures

    def picture(self, view: str) -> Drawn:
        return next(each for each in self.drawn if each.view == view)


def write_result(
    out_dir: Path, lowered: PovrayScene, outcomes: list[Outcome], version: str, threads: int, wall_s: float
) -> Rendering:
    """Write the scene texts with their skies, the image and the record, in this order, each whole or not at all."""
    out_dir.mkdir(parents=True, exist_ok=True)
    record = _record(version, lowered, outcomes, threads, wall_s)
    for run in lowered.runs:
        for name, text in run.texts.items():
            write_whole(out_dir / "povray" / name, text)
        if run.sky is not None:
            write_sky(out_dir / "povray" / run.sky.name, run.sky.pixels)
    image = _write_image(out_dir / "povray.exr", "", lowered, outcomes, version)
    views = {
        view.name: _write_image(out_dir / f"povray.{view.name}.exr", view.name, lowered, outcomes, version)
        for view in lowered.views
    }
    write_whole(out_dir / "povray.run.json", canonical_json(record))
    return Rendering(image, record, views)


def half_images(outcomes: list[Outcome], view: str = "") -> dict[str, np.ndarray]:
    """The radiance of each half in one view: the sum of its runs, each times its gain."""
    found: dict[str, np.ndarray] = {}
    for outcome in outcomes:
        part = outcome.picture(view).image * np.array(outcome.run.gain)
        found[outcome.run.half] = found[outcome.run.half] + part if outcome.run.half in found else part
    return found


def _write_image(path: Path, view: str, lowered: PovrayScene, outcomes: list[Outcome], version: str) -> Path:
    """Both halves, their mean, and the variance of the mean, (a - b)^2 / 4."""
    a, b = half_images(outcomes, view).values()
    metadata = {
        "vitrail:scene_hash": lowered.scene_hash,
        "vitrail:engine": f"POV-Ray {version}",
        "vitrail:settings": json.dumps(_settings(lowered, outcomes, view), sort_keys=True),
    }
    if view:
        metadata["vitrail:view"] = view
    with whole_file(path) as partial:
        write_image(partial, (a + b) / 2, half_a=a, half_b=b, variance=(a - b) ** 2 / 4, metadata=metadata)
    return path


def _settings(lowered: PovrayScene, outcomes: list[Outcome], view: str = "") -> dict[str, Any]:
    """The settings asked for, and what became of them in one picture."""
    photons, units = lowered.photons, lowered.normalisation
    return {
        **lowered.settings.as_record(),
        "mode": lowered.mode.name,
        "mode_reason": lowered.mode.reason,
        "samples_used": _samples_used(lowered, view),
        "photons_used": sum(each.census.shot.statistics.photons_shot for each in outcomes if each.census),
        "spacing_m": {half: spacing / units.scale for half, spacing in photons.spacing.items()} if photons else {},
        "units_per_metre": units.scale,
        "centre_m": list(units.centre),
        "max_trace_level": lowered.runs[0].max_trace_level,
    }


def _samples_used(lowered: PovrayScene, view: str) -> int:
    """Samples of a pixel in one picture, of both halves; one place that both look at counts once."""
    halves = {run.half: each for run in lowered.runs for each in run.pictures if each.view == view}
    counts = [each.samples_across * each.samples_down for each in halves.values()]
    return 1 if counts == [1, 1] else sum(counts)


def _record(version: str, lowered: PovrayScene, outcomes: list[Outcome], threads: int, wall_s: float) -> dict[str, Any]:
    """The run record of both engines, with what only POV-Ray has in ``runs``, ``certificate`` and ``isolation``."""
    done = [outcome for outcome in outcomes if not outcome.is_repeated]
    executions = [execution for outcome in done for execution in outcome.executions]
    rendered = [drawn.done for outcome in done for drawn in outcome.drawn]
    shot = [outcome.census.shot for outcome in done if outcome.census]

    def cpu(phase: str, where: list[Execution]) -> float:
        return math.fsum(execution.statistics.cpu_s[phase] for execution in where)

    def count(name: str, where: list[Execution]) -> int:
        return sum(getattr(execution.statistics, name) for execution in where)

    return {
        "vitrail_run": 1,
        "engine": "povray",
        "version": version,
        "scene_hash": lowered.scene_hash,
        "settings": _settings(lowered, outcomes),
        "threads": threads,
        "cpu_s": {
            "total": math.fsum(execution.finished.cpu_s for execution in executions),
            "build": cpu("parse", executions) + cpu("bounding", executions),
            # POV-Ray times shooting and its own sorting together.
            "photon_pass": cpu("photon", shot),
            "photon_sort": 0.0,
            "photon_order": math.fsum(outcome.census.order_cpu_s for outcome in done if outcome.census),
            # It gathers while it traces.
            "camera": cpu("trace", rendered),
            "gather": 0.0,
        },
        "wall_s": wall_s,
        "peak_memory_bytes": max(execution.finished.peak_memory_bytes for execution in executions),
        "counters": {
            "camera_rays": count("rays", rendered),
            "shadow_rays": count("shadow_tests", rendered),
            "photons_emitted": count("photons_shot", shot),
            "photons_stored": sum(outcome.census.stored for outcome in done if outcome.census),
            # It counts gathers only where it shoots; where it loads photons, a ray gathers once at most.
            "gather_queries": count("gather_calls", rendered) or (count("rays", rendered) if shot else 0),
        },
        "adc_bailout": lowered.adc_bailout,
        "certificate": lowered.certificate.as_json(),
        "isolation": list(executions[0].walls),
        "runs": [_run_record(outcome) for outcome in outcomes],
        "views": [_view_record(lowered, done, view.name) for view in lowered.views],
        "warnings": _warnings(outcomes),
        "interrupted": False,
    }


def _run_record(outcome: Outcome) -> dict[str, Any]:
    census = outcome.census
    return {
        "name": outcome.run.name,
        "is_repeated": outcome.is_repeated,
        "gain": list(outcome.run.gain),
        "statistics": asdict(outcome.picture("").done.statistics),
        "photons": None
        if census is None
        else {
            "statistics": asdict(census.shot.statistics),
            "stored": census.stored,
            "flux_units": [float(value) for value in census.flux],
        },
    }


def _view_record(lowered: PovrayScene, done: list[Outcome], view: str) -> dict[str, Any]:
    """What one view took of the counters and of the CPU seconds; POV-Ray gathers while it traces."""
    drawn = [outcome.picture(view).done for outcome in done]
    return {
        "name": view,
        "samples_used": _samples_used(lowered, view),
        "camera_rays": sum(each.statistics.rays for each in drawn),
        "cpu_s": {
            "total": math.fsum(each.finished.cpu_s for each in drawn),
            "camera": math.fsum(each.statistics.cpu_s["trace"] for each in drawn),
            "gather": 0.0,
        },
    }


def _warnings(outcomes: list[Outcome]) -> list[str]:
    """Rays that met the limit of depth, branches that were cut, and photons that all left the scene."""
    limits = {
        drawn.done.statistics.level_limit
        for outcome in outcomes
        for drawn in outcome.drawn
        if drawn.done.statistics.deepest_level >= drawn.done.statistics.level_limit > 0
    }
    found = [f"camera rays reached the limit of {limit} levels; what lies deeper is black" for limit in limits]
    found += _cut_branches(outcomes)
    census = [outcome.census for outcome in outcomes if outcome.census is not None]
    if census and not any(each.stored for each in census):
        shot = sum(each.shot.statistics.photons_shot for each in census)
        found.append(f"none of {shot} photons met a surface that scatters; the picture has no caustic")
    return found


def _cut_branches(outcomes: list[Outcome]) -> list[str]:
    """What a look at the scene loses at most by branches that are cut: each less than the weight that cuts it."""
    most = 0.0
    for outcome in outcomes:
        own = next(each for each in outcome.run.pictures if not each.view)
        cut = outcome.picture("").done.statistics.cut_by_weight
        most = max(most, cut / (own.width * own.height) * outcome.run.adc_bailout)
    if most <= NOTICEABLE_LOSS:
        return []
    remedy = "lower `max_reflections`, or ask for `quality=reference`, which cuts later"
    return [f"branches of weak light were cut; up to {min(most, 1):.2g} of what a look sees may be missing; {remedy}"]


def write_sky(path: Path, pixels: np.ndarray) -> None:
    """Write a sky whole, and once for all runs that see it: its name says the content. Raises ImageError."""
    if not path.is_file():
        with whole_file(path) as partial:
            write_image(partial, pixels, pixel_type="half")
