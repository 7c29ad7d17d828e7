"""Many scenes: each through both engines, then all judged together at one false-alarm rate."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import replace
from pathlib import Path

from vitrail.base.progress import Progress
from vitrail.judge.exit_code import INTERRUPTED, of_run, of_scene
from vitrail.judge.false_alarms import SUITE_FALSE_ALARM_RATE, sidak
from vitrail.judge.judgement import judge_observation
from vitrail.judge.records import Results, Run, SceneResult, Status, write_results
from vitrail.judge.references import read_scene_truth, references_folder
from vitrail.judge.stored import read_stored
from vitrail.judge.thresholds import Thresholds, thresholds_of
from vitrail.judge.verdict import overall
from vitrail.pipeline.ablate import deviates_between_engines, search_whereabouts, with_whereabouts
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.more_samples import more, offer
from vitrail.pipeline.own_defect import TRACEBACK, defective, is_own_defect, unsearched
from vitrail.pipeline.request import Request
from vitrail.pipeline.scene_run import SceneRun, run_scene
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash

Watch = Callable[[str, str, float, float], None]
"""Called with the scene, the phase, the work done and the work in all."""


def compare(scenes: Sequence[Loaded], request: Request, watch: Watch = lambda *step: None) -> Results:
    """Run every scene, judge all, write ``results.json`` after each, and return the results.

    Ctrl-C keeps what has finished: the results are marked interrupted and hold those scenes. A defect of this program
    is the end of the scene that met it, and of no other.
    """
    about, clock = about_run(request.command, request.threads), time.monotonic()
    _check_references(scenes, request)
    request.out.mkdir(parents=True, exist_ok=True)
    names = scene_names([loaded.path for loaded in scenes])
    by_name = dict(zip(names, scenes, strict=True))
    runs: dict[str, SceneRun] = {}
    left_s: dict[str, float] = {}
    interrupted = False

    def finish() -> Results:
        ordered = [runs[name] for name in names if name in runs]
        spent = {"wall_s": round(time.monotonic() - clock, 3), "interrupted": interrupted}
        results = judge(
            ordered,
            about.model_copy(update=spent),
            looks=1 + request.rounds,
            spared=lambda name, error: defective(by_name[name], name, request, error),
        )
        results = _priced(results, by_name, left_s, request)
        write_results(results, request.out / "results.json")
        return results

    try:
        todo = [(name, loaded, request) for name, loaded in zip(names, scenes, strict=True)]
        for _ in range(1 + request.rounds):
            for name, run in _each(todo, request.jobs, watch):
                # An engine that was interrupted brings its unfinished image home; the rest must not start then.
                if run.record.status is Status.INTERRUPTED:
                    raise KeyboardInterrupt
                # The first look is what was asked for; only those after it are paid from the budget.
                left_s[name] = left_s[name] - _cpu_s(run.record) if name in left_s else request.budget_s
                runs[name] = run
                finish()
            todo = _undecided(finish(), by_name, request)
        for record in finish().scenes:
            if any(deviates_between_engines(entry) for entry in record.observations):
                run = runs[record.name]
                watched, left = _watched(watch, record.name), left_s[record.name]
                runs[record.name] = _searched(run, by_name[record.name], record, request, left, watched)
    except KeyboardInterrupt:
        interrupted = True
    return finish()


def _check_references(scenes: Sequence[Loaded], request: Request) -> None:
    """Refuse unusable references before an hour of rendering, not after it."""
    for loaded in scenes:
        folder = references_folder(loaded.path, request.references)
        thresholds_of(folder)
        read_scene_truth(folder, loaded.path.stem, loaded.scene)
        if "stored" in request.against:
            read_stored(folder, loaded.path.stem, scene_hash(loaded.scene))


def _priced(results: Results, scenes: Mapping[str, Loaded], left_s: Mapping[str, float], request: Request) -> Results:
    """The results, each scene in doubt with what it would cost to decide it."""
    priced = []
    for scene in results.scenes:
        left, is_fixed = max(left_s[scene.name], 0.0), scenes[scene.name].scene.image.samples is not None
        wish = offer(scene, left, request.budget_s, fixed_samples=is_fixed)
        priced.append(scene.model_copy(update={"more_samples": wish}))
    return results.model_copy(update={"scenes": tuple(priced)})


def _undecided(results: Results, scenes: Mapping[str, Loaded], request: Request) -> list[tuple[str, Loaded, Request]]:
    """The scenes in doubt that can pay, each with a request for as many more samples as its numbers ask for."""
    found = []
    for scene in results.scenes:
        wish = scene.more_samples
        if wish is not None and wish.affordable and wish.factor is not None:
            loaded = scenes[scene.name]
            bought = more(scene.settings, wish.factor, fixed_samples=loaded.scene.image.samples is not None)
            found.append((scene.name, loaded, replace(request, overrides={**request.overrides, **bought})))
    return found


def _cpu_s(record: SceneResult) -> float:
    """What one look at a scene took, both engines together."""
    return sum(engine.cpu_s or 0.0 for engine in record.engines)


def judge(
    runs: Sequence[SceneRun],
    about: Run,
    *,
    looks: int = 1,
    comparisons: int | None = None,
    spared: Callable[[str, Exception], SceneResult] | None = None,
) -> Results:
    """All verdicts of a run, at the level that its number of comparisons asks for, each looked at ``looks`` times.

    ``comparisons`` gives that number where not all of them are in ``runs``; it is never taken for less than there are.
    ``spared`` makes the record of a scene in whose judgement this program fails; without it the error goes on.
    """
    own = looks * sum(len(observed.measured) for run in runs for observed in run.observed)
    comparisons = max(own, comparisons or 0)
    folders = {run.references for run in runs if run.references is not None}
    rules = {folder: thresholds_of(folder) for folder in folders}
    rate = min((each.suite_false_alarm_rate for each in rules.values()), default=SUITE_FALSE_ALARM_RATE)
    shared = sidak(rate, comparisons)
    scenes = tuple(_judged_or_spared(run, rules, shared.level, spared) for run in runs)
    keys = [scene.verdict.value if scene.verdict else "unjudged" for scene in scenes]
    codes = [scene.exit_code for scene in scenes] + ([INTERRUPTED] if about.interrupted else [])
    return Results(
        run=about,
        false_alarms=shared,
        scenes=scenes,
        counts={key: keys.count(key) for key in sorted(set(keys))},
        verdict=overall(scene.verdict for scene in scenes),
        exit_code=of_run(codes),
    )


def scene_names(paths: Sequence[Path]) -> list[str]:
    """One folder name a scene: the stem of its file, with its folder before it where two would be the same."""
    stems = [path.stem for path in paths]
    names = [
        path.stem if stems.count(path.stem) == 1 else f"{path.resolve().parent.name}-{path.stem}" for path in paths
    ]
    return [name if names.index(name) == place else f"{name}-{place}" for place, name in enumerate(names)]


def _each(todo: list[tuple[str, Loaded, Request]], jobs: int, watch: Watch) -> Iterator[tuple[str, SceneRun]]:
    """(name, run) of every scene as it finishes, ``jobs`` at a time."""
    if jobs == 1:
        for name, loaded, request in todo:
            yield name, _spared(loaded, name, request, _watched(watch, name))
        return
    waiting = list(reversed(todo))
    with ThreadPoolExecutor(jobs) as pool:
        going: dict[Future[SceneRun], str] = {}
        try:
            while waiting or going:
                while waiting and len(going) < jobs:
                    name, loaded, request = waiting.pop()
                    going[pool.submit(_spared, loaded, name, request, _watched(watch, name))] = name
                for future in wait(going, return_when=FIRST_COMPLETED).done:
                    yield going.pop(future), future.result()
        finally:
            for future in going:
                future.cancel()


def _watched(watch: Watch, name: str) -> Callable[[str, float, float], None]:
    return lambda phase, done, total: watch(name, phase, done, total)


def _spared(loaded: Loaded, name: str, request: Request, progress: Progress) -> SceneRun:
    """A scene's run; a defect of this program that it meets is its end, and that of no other scene."""
    (request.out / name / TRACEBACK).unlink(missing_ok=True)
    try:
        return run_scene(loaded, name, request, progress)
    except Exception as error:
        if not is_own_defect(error):
            raise
        return SceneRun(defective(loaded, name, request, error))


def _searched(
    run: SceneRun, loaded: Loaded, record: SceneResult, request: Request, left_s: float, progress: Progress
) -> SceneRun:
    """The run with what was tried to find where its engines deviate; a defect met there takes no verdict away."""
    assert run.references is not None
    try:
        return replace(run, search=search_whereabouts(loaded, run.references, record, request, left_s, progress))
    except Exception as error:
        if not is_own_defect(error):
            raise
        warnings = (*run.record.warnings, unsearched(record, request, error))
        return replace(run, record=run.record.model_copy(update={"warnings": warnings}))


def _judged_or_spared(
    run: SceneRun,
    rules: Mapping[Path, Thresholds],
    level: float,
    spared: Callable[[str, Exception], SceneResult] | None,
) -> SceneResult:
    if run.references is None:
        return _coded(run.record)
    try:
        return _judged(run, rules[run.references], level)
    except Exception as error:
        if spared is None or not is_own_defect(error):
            raise
        return _coded(spared(run.record.name, error))


def _judged(run: SceneRun, thresholds: Thresholds, level: float) -> SceneResult:
    """The scene's record with its verdicts; a scene that observes nothing has judged nothing and says so."""
    judged = [judge_observation(each, thresholds, run.residual, level) for each in run.observed]
    observations = with_whereabouts(judged, run.search, thresholds, level)
    words = [each.verdict for each in observations] + [each.verdict for each in run.record.global_metrics]
    verdict = overall(words) if observations else None
    update: dict[str, object] = {"observations": observations, "verdict": verdict}
    if verdict is None:
        update |= {"status": Status.SCENE_ERROR, "message": "the scene observes nothing; add an `observe` entry"}
    return _coded(run.record.model_copy(update=update))


def _coded(record: SceneResult) -> SceneResult:
    return record.model_copy(update={"exit_code": of_scene(record.status, record.verdict)})
