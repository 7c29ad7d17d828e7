"""Judge the scenes of a run together, because they share one false-alarm rate."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.base.exit_code import ExitCode
from vitrail.judge.bound import worst
from vitrail.judge.exit_code import of_run, of_scene
from vitrail.judge.false_alarms import SUITE_FALSE_ALARM_RATE, sidak
from vitrail.judge.judgement import judge_observation
from vitrail.judge.records import Results, Run, SceneResult, Status
from vitrail.judge.statements import run_statement, scene_headline, scene_statement
from vitrail.judge.thresholds import Thresholds, thresholds_of
from vitrail.judge.verdict import overall
from vitrail.pipeline.ablate import with_whereabouts
from vitrail.pipeline.scene_run import SceneRun

Judge = Callable[[SceneRun, Thresholds, float], SceneResult]
"""Gives a scene its verdicts by these rules at this level of confidence."""


def judge_scene(run: SceneRun, rules: Thresholds, level: float) -> SceneResult:
    """The scene's record with its verdicts; a scene that observes nothing has judged nothing and says so."""
    judged = [judge_observation(each, rules, run.residual, level) for each in run.observed]
    observations = with_whereabouts(judged, run.search, rules, level)
    words = [each.verdict for each in observations] + [each.verdict for each in run.record.global_metrics]
    if run.record.scan is not None:
        words.append(run.record.scan.verdict)
    verdict = overall(words) if observations else None
    update: dict[str, object] = {
        "observations": observations,
        "verdict": verdict,
        "bound": worst(entry for each in observations for entry in each.comparisons),
        "statement": scene_statement(observations, run.record.scan),
        "headline": scene_headline(observations, run.record.scan),
    }
    if verdict is None:
        update |= {"status": Status.SCENE_ERROR, "message": "the scene observes nothing; add an `observe` entry"}
    return changed(run.record, **update)


def judge(
    runs: Sequence[SceneRun],
    about: Run,
    *,
    looks: int = 1,
    comparisons: int | None = None,
    judge_one: Judge = judge_scene,
) -> Results:
    """All verdicts of a run, at the level that its number of comparisons asks for, each looked at ``looks`` times.

    ``comparisons`` gives that number where not all of them are in ``runs``; it is never taken for less than there are.
    A scene that came to no numbers keeps its record.
    """
    own = looks * sum(len(observed.measured) for run in runs for observed in run.observed)
    rules = {run.references: thresholds_of(run.references) for run in runs if run.references is not None}
    shared = sidak(_rate(rules), max(own, comparisons or 0))
    scenes = tuple(
        _with_exit_code(run.record if run.references is None else judge_one(run, rules[run.references], shared.level))
        for run in runs
    )
    keys = [scene.verdict.value if scene.verdict else "unjudged" for scene in scenes]
    counts = {key: keys.count(key) for key in sorted(set(keys))}
    codes = [scene.exit_code for scene in scenes] + ([ExitCode.INTERRUPTED] if about.interrupted else [])
    return Results(
        run=about,
        false_alarms=shared,
        scenes=scenes,
        counts=counts,
        verdict=overall(scene.verdict for scene in scenes),
        statement=run_statement(counts),
        exit_code=of_run(codes),
    )


def _rate(rules: Mapping[Path, Thresholds]) -> float:
    """The strictest false-alarm rate that any of the references ask for."""
    return min((each.suite_false_alarm_rate for each in rules.values()), default=SUITE_FALSE_ALARM_RATE)


def _with_exit_code(record: SceneResult) -> SceneResult:
    return changed(record, exit_code=of_scene(record.status, record.verdict))
