"""Inject every mutant into the bench of calibration scenes and see what is reported: the confusion matrix.

Only scenes whose lowered form a mutant changes are rendered again; the others keep the clean run's result, which is
what a second run would give.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from vitrail.judge.diagnosis import Diagnosis, diagnose
from vitrail.judge.records import Results, SceneResult
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import Loaded, load
from vitrail.study.compare.render import lower_both, povray_key, tracer_key
from vitrail.study.compare.request import Defect, Request
from vitrail.study.compare.scene_run import SceneRun, run_scene
from vitrail.study.compare.suite import about_run, judge
from vitrail.study.mutants.catalogue import MUTANTS
from vitrail.study.mutants.mutant import Mutant
from vitrail.study.queue import Progress, Work, run_tasks
from vitrail.study.task import Row, Task
from vitrail.study.task_log import TaskLog

BENCH = (
    "grey_card_directional",
    "grey_card_point",
    "penumbra",
    "ambient_card",
    "mirror",
    "slab_tilted",
    "reflecting_prism",
    "tinted_pane_seen",
    "tinted_pane_projected",
    "beer_wedge",
    "prism_screen",
    "ball_lens",
)
"""At least one calibration scene a phenomenon."""

ALONE: Mapping[str, tuple[float, str]] = {
    "ssim": (0.95, "below"),
    "flip": (0.05, "above"),
    "relmse": (0.01, "above"),
}
"""Customary thresholds on whole images: what one number over the picture would have said."""


@dataclass(frozen=True)
class Bench:
    """The scenes with their clean results, and the folder of finished renderings."""

    scenes: Mapping[str, Loaded]
    clean: Mapping[str, SceneRun]
    request: Request


def run_mutants(
    bench_folder: Path,
    out: Path,
    *,
    mutants: Sequence[Mutant] = MUTANTS,
    report: Callable[[Progress], None] = lambda progress: None,
) -> dict[str, Any]:
    """Measure what is missing in ``out`` and write mutants.json; returns its content."""
    bench = clean_bench(bench_folder, out)
    known = {mutant.name: mutant for mutant in mutants}
    tasks = [Task("mutant", {"name": name, "bench": _bench_content(bench)}) for name in known]
    work: dict[str, Work] = {"mutant": lambda spec: (_inject(known[spec["name"]], bench), {})}
    rows = run_tasks(tasks, TaskLog(out), work, report=report)
    entries = [_record(known[row.spec["name"]], row) for row in rows]
    found = {
        "vitrail_mutants": 1,
        "clean": _diagnosis_record(diagnose(_judged(bench, bench.clean).scenes)),
        "mutants": entries,
        "caught": sum(1 for entry in entries if entry["reported"] is not None),
        "named": sum(1 for entry in entries if entry["reported"] == entry["injected"]),
    }
    (out / "mutants.json").write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")
    return found


def clean_bench(folder: Path, out: Path) -> Bench:
    """Every bench scene without any defect."""
    scenes = {name: load(folder / f"{name}.yaml") for name in BENCH}
    request = Request(out=out / "bench")
    clean = {name: run_scene(loaded, name, request, _quiet) for name, loaded in scenes.items()}
    return Bench(scenes, clean, request)


def _inject(mutant: Mutant, bench: Bench) -> dict[str, Any]:
    """Render and judge the bench with one mutant in it."""
    request = replace(bench.request, defect=mutant.defect)
    touched = [
        name for name, loaded in bench.scenes.items() if _content(loaded, request) != _content(loaded, bench.request)
    ]
    if not touched:
        raise ValueError(f"{mutant.name} changes no scene of the bench; it tests nothing")
    runs = {**bench.clean, **{name: run_scene(bench.scenes[name], name, request, _quiet) for name in touched}}
    results = _judged(bench, runs)
    found = diagnose(results.scenes)
    changed = [scene for scene in results.scenes if scene.name in touched]
    return {"touched": touched, **_diagnosis_record(found), "alone": _alone(changed)}


def _judged(bench: Bench, runs: Mapping[str, SceneRun]) -> Results:
    return judge([runs[name] for name in bench.scenes], about_run((), 0))


def _content(loaded: Loaded, request: Request) -> tuple[str, str]:
    """What decides both images of a scene."""
    plan = analyse(loaded.scene)
    settings = settings_for(loaded.scene, plan, request.quality, **request.overrides)
    lowered = lower_both(loaded, plan, settings, request)
    return tracer_key("", lowered.tracer), povray_key("", lowered.povray)


def _bench_content(bench: Bench) -> list[str]:
    """What a stored row depends on besides the mutant."""
    clean = replace(bench.request, defect=Defect())
    return [key for loaded in bench.scenes.values() for key in _content(loaded, clean)]


def _alone(scenes: Sequence[SceneResult]) -> dict[str, Any]:
    """The worst whole-image number over the changed scenes, and whether its customary threshold would have stopped."""
    verdicts = {}
    for metric, (threshold, side) in ALONE.items():
        values = [entry.value for scene in scenes for entry in scene.global_metrics if entry.metric == metric]
        if values:
            worst = min(values) if side == "below" else max(values)
            verdicts[metric] = {"worst": worst, "caught": worst < threshold if side == "below" else worst > threshold}
    return verdicts


def _diagnosis_record(found: Diagnosis) -> dict[str, Any]:
    return {
        "reported": found.phenomenon.value if found.phenomenon else None,
        "engine": found.engine,
        "deviating": [phenomenon.value for phenomenon in found.deviating],
    }


def _record(mutant: Mutant, row: Row) -> dict[str, Any]:
    blank: dict[str, Any] = {"reported": None, "engine": None, "deviating": [], "touched": [], "alone": {}}
    return {
        "name": mutant.name,
        "place": mutant.place,
        "what": mutant.what,
        "injected": mutant.phenomenon.value,
        "injected_engine": mutant.engine,
        "failure": row.failure,
        **(row.result or blank),
    }


def _quiet(phase: str, done: float, total: float) -> None:
    """Nobody watches a single scene of the bench."""
