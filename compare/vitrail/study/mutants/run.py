"""Inject every mutant into the bench and see what is reported: the confusion matrix.

Only scenes whose lowered form a mutant changes are rendered again; the others keep the clean run's result, which is
what a second run would give.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from vitrail.base.progress import Progress, silent
from vitrail.base.record import JsonObject, write_record
from vitrail.judge.comparison import Pair, Verdict
from vitrail.judge.diagnosis import Diagnosis, diagnose
from vitrail.judge.records import Results, Status
from vitrail.pipeline.campaign import Campaign, Work, run_campaign
from vitrail.pipeline.compare import compare_scene
from vitrail.pipeline.defect import Defect
from vitrail.pipeline.scene_run import SceneRun, SceneTask
from vitrail.pipeline.task import Row, Task
from vitrail.study.mutants.ablated import clean_ablations, whereabouts_of
from vitrail.study.mutants.bench import Bench, alone, clean_bench, content
from vitrail.study.mutants.catalogue import MUTANTS
from vitrail.study.mutants.mutant import Mutant
from vitrail.study.mutants.records import CleanBench, Injection, MutantEntry, Mutants, Reported, Witness


def run_mutants(
    scenes: Path,
    out: Path,
    *,
    mutants: Sequence[Mutant] = MUTANTS,
    jobs: int = 1,
    progress: Progress = silent,
) -> Mutants:
    """Measure what is missing in ``out`` and write mutants.json; returns its content. ``scenes``: the scene folders."""
    start = time.thread_time()
    bench = clean_bench(scenes, out)
    bench_cpu_s = time.thread_time() - start + _engines_s(bench.clean.values(), ("tracer", "povray"))
    known = {mutant.name: mutant for mutant in mutants}
    tasks = [Task("mutant", {"name": name, "what": known[name].what, "bench": _content(bench)}) for name in known]
    work: dict[str, Work] = {"mutant": lambda spec: _measured(known[spec["name"]], bench, out / spec["name"])}
    rows = run_campaign(Campaign(tasks, work), out, jobs=jobs, progress=progress)
    clean = CleanBench(
        **dict(_reported(diagnose(bench.judged(bench.clean).scenes))),
        scenes=tuple(bench.scenes),
        alone={metric: tuple(sorted(names)) for metric, names in bench.alarms.items()},
        ablated=clean_ablations(bench),
    )
    entries = tuple(_entry(known[row.spec["name"]], row) for row in rows)
    found = Mutants(
        clean=clean,
        mutants=entries,
        caught=sum(entry.reported is not None for entry in entries),
        named=sum(entry.reported is entry.injected for entry in entries),
        located=sum(entry.suspects == (entry.injected,) for entry in entries),
        cpu_s=round(bench_cpu_s + sum(row.cost.get("cpu_s", 0.0) for row in rows)),
    )
    write_record(found, out / "mutants.json")
    return found


def _measured(mutant: Mutant, bench: Bench, place: Path) -> tuple[JsonObject, JsonObject]:
    """One mutant and what it cost. Its folder shares the finished renderings of the clean bench."""
    start = time.thread_time()
    place.mkdir(parents=True, exist_ok=True)
    shared = place / ".cache"
    if not shared.exists():
        shared.symlink_to(next(iter(bench.requests.values())).cache.resolve())
    result, runs = _inject(mutant, bench, place)
    return result.model_dump(mode="json"), {"cpu_s": time.thread_time() - start + _engines_s(runs, (mutant.engine,))}


def _inject(mutant: Mutant, bench: Bench, place: Path) -> tuple[Injection, list[SceneRun]]:
    """Render and judge the bench with one mutant in it; returns what was found and the scenes that were rendered."""
    touched = bench.touched(mutant.defect)
    if not touched:
        raise ValueError(f"{mutant.name} changes no scene of the bench; it tests nothing")
    requests = {name: replace(bench.requests[name], defect=mutant.defect, out=place) for name in touched}
    runs = {name: compare_scene(SceneTask(name, bench.scenes[name], requests[name])) for name in touched}
    results = bench.judged({**bench.clean, **runs})
    found = diagnose(results.scenes)
    # A black picture is stopped before anything is measured; a mutant that only does that has tested no verdict.
    refused = {name: run.record.message for name, run in runs.items() if run.record.status is not Status.JUDGED}
    if refused and found.phenomenon is None:
        raise ValueError(f"{mutant.name} is stopped and not measured; {refused}")
    result = Injection(
        **dict(_reported(found)),
        touched=tuple(touched),
        stopped=tuple(sorted(refused)),
        witness=_witness(results, found),
        where=whereabouts_of(found, results, runs, requests, bench),
        alone=alone(bench, [scene for scene in results.scenes if scene.name in touched]),
    )
    return result, list(runs.values())


def _witness(results: Results, found: Diagnosis) -> Witness | None:
    """The number that is furthest beyond its tolerance in the observation that the diagnosis rests on."""
    entries = [
        entry
        for scene in results.scenes
        for observation in scene.observations
        if (scene.name, observation.name) == (found.scene, found.observation)
        for entry in observation.comparisons
        if entry.verdict is Verdict.DEVIATES and entry.pair is Pair.TRACER_POVRAY
    ]
    if not entries:
        return None
    worst = max(entries, key=lambda entry: abs(entry.difference) / max(entry.tolerance, 1e-12))
    return Witness(
        metric=worst.metric,
        difference=worst.difference,
        half_width=worst.interval.half_width,
        tolerance=worst.tolerance,
        unit=worst.unit,
    )


def _content(bench: Bench) -> list[str]:
    """What a stored row depends on besides the mutant."""
    clean = {name: replace(request, defect=Defect()) for name, request in bench.requests.items()}
    versions = [engine.version() for request in [next(iter(clean.values()))] for engine in request.engines.values()]
    return versions + [key for name, loaded in bench.scenes.items() for key in content(loaded, clean[name])]


def _reported(found: Diagnosis) -> Reported:
    return Reported(reported=found.phenomenon, engine=found.engine, deviating=tuple(found.deviating), scene=found.scene)


def _entry(mutant: Mutant, row: Row) -> MutantEntry:
    """One mutant with what came of it; a failed one has nothing but its words."""
    return MutantEntry(
        **dict(Injection.model_validate(row.result or {})),
        name=mutant.name,
        place=mutant.place,
        what=mutant.what,
        injected=mutant.phenomenon,
        injected_engine=mutant.engine,
        failure=row.failure,
    )


def _engines_s(runs: Iterable[SceneRun], engines: Sequence[str]) -> float:
    """CPU seconds of the engines' own processes."""
    return sum(each.cpu_s or 0.0 for run in runs for each in run.record.engines if each.engine in engines)
