"""What ablation says of the bench: where each mutant lives, and whether switching anything off makes a deviation."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from vitrail.judge.comparison import ObservationResult, Verdict
from vitrail.judge.diagnosis import Diagnosis
from vitrail.judge.judgement import judge_observation
from vitrail.judge.records import Results
from vitrail.judge.thresholds import thresholds_of
from vitrail.judge.whereabouts import LIGHT_FAMILIES
from vitrail.pipeline.ablate import search_whereabouts
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.judge import judge
from vitrail.pipeline.request import Request
from vitrail.pipeline.scene_run import SceneRun
from vitrail.study.mutants.bench import Bench
from vitrail.study.mutants.records import AblatedWitness, CleanAblations


def whereabouts_of(
    found: Diagnosis, results: Results, runs: Mapping[str, SceneRun], requests: Mapping[str, Request], bench: Bench
) -> AblatedWitness | None:
    """Suspects and outcomes for the observation that a diagnosis rests on; None where the engines agree there."""
    record = next((scene for scene in results.scenes if scene.name == found.scene), None)
    if record is None or record.name not in runs:
        return None
    run = runs[record.name]
    assert run.references is not None
    loaded = bench.scenes[record.name]
    tried = search_whereabouts(loaded, run.references, record, requests[record.name], math.inf)
    again = judge([replace(run, search=tried)], about_run((), 0), comparisons=results.false_alarms.comparisons)
    where = next(entry.where for entry in again.scenes[0].observations if entry.name == found.observation)
    if where is None:
        return None
    outcomes = {entry.off: entry.outcome for entry in where.ablations}
    return AblatedWitness(suspects=where.suspects, ablations=outcomes)


def clean_ablations(bench: Bench) -> CleanAblations:
    """Every ablation of every clean scene: how many there are, and those whose engines do not agree, or that failed.

    An ablation that makes a deviation where there was none changes something in one engine only, and would mislead.
    """
    results = bench.judged(bench.clean)
    apart: dict[str, str] = {}
    level, count = results.false_alarms.level, 0
    for record in results.scenes:
        run, request = bench.clean[record.name], bench.requests[record.name]
        assert run.references is not None
        rules, loaded = thresholds_of(run.references), bench.scenes[record.name]
        tried = search_whereabouts(loaded, run.references, record, request, math.inf, everywhere=True)
        for scene in tried.ablated:
            count += 1
            judged = [judge_observation(each, rules, scene.residual, level) for each in scene.observed.values()]
            words = [f"{each.name} {each.verdict.value}" for each in judged if _is_apart(each, scene.ablation.name)]
            if words or scene.reason:
                apart[f"{record.name}, {scene.ablation.name}"] = scene.reason or ", ".join(words)
    return CleanAblations(count=count, apart=apart)


def _is_apart(observation: ObservationResult, off: str) -> bool:
    """Whether any number does not agree; of a phenomenon that is off only those of the light are of something."""
    is_own = observation.phenomenon.value == off
    return any(
        entry.verdict is not Verdict.AGREES
        for entry in observation.comparisons
        if not is_own or entry.metric.split(".")[0] in LIGHT_FAMILIES
    )
