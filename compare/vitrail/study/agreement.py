"""How far the engines agree, phenomenon by phenomenon: the comparisons of finished runs, one row a number.

A number with several parts (channels, rings, positions) gives the row of the part that is worst off. ``certificate`` is
what the translation allows, in the unit of the number; ``beyond`` is how far the whole interval of the difference lies
outside of it, which the threshold of the metric may still forgive: such rows are findings, whatever their verdict.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from itertools import groupby
from pathlib import Path
from statistics import median
from typing import Any

from vitrail.judge.comparison import Comparison, ObservationResult, Pair, Verdict
from vitrail.judge.records import Results, SceneResult

PAIRS = (Pair.TRACER_POVRAY, Pair.POVRAY_TRUTH)
"""The engines against each other, and POV-Ray against closed forms."""
WORST_LAST = (Verdict.AGREES, Verdict.INCONCLUSIVE, Verdict.DEVIATES)


def agreement(runs: Sequence[Results]) -> dict[str, Any]:
    """Scenes and rows of several runs; a scene that is in more than one counts as the last run has it."""
    scenes = {scene.name: scene for run in runs for scene in run.scenes}
    rows = [row for scene in scenes.values() for row in _rows(scene)]
    rows.sort(key=lambda row: (row["phenomenon"], row["pair"], row["metric"], row["scene"], row["observation"]))
    return {
        "vitrail_agreement": 1,
        "scenes": [_scene(scenes[name]) for name in sorted(scenes)],
        "rows": rows,
        "phenomena": [_summary(group) for group in _grouped(rows)],
    }


def write_agreement(found: dict[str, Any], path: Path) -> None:
    """Sorted keys and short lines, so that two runs can be compared line by line."""
    path.write_text(json.dumps(found, indent=1, sort_keys=True, allow_nan=False) + "\n", encoding="utf-8")


def _scene(scene: SceneResult) -> dict[str, Any]:
    """What a reader needs to make the run again, and to see what it cost."""
    return {
        "name": scene.name,
        "status": scene.status.value,
        "scene_hash": scene.scene_hash,
        "settings": {key: scene.settings.get(key) for key in ("quality", "samples", "photons", "gather_radius_m")},
        "cpu_s": {engine.engine: round(engine.cpu_s, 1) for engine in scene.engines if engine.cpu_s is not None},
    }


def _rows(scene: SceneResult) -> Iterable[dict[str, Any]]:
    for observation in scene.observations:
        kept = [each for each in observation.comparisons if each.pair in PAIRS]
        kept.sort(key=_number)
        for _, parts in groupby(kept, key=_number):
            yield _row(scene, observation, max(parts, key=_how_bad))


def _number(comparison: Comparison) -> tuple[str, str]:
    """The pair and the number without its part: `flux_ratio` of `flux_ratio.red`."""
    return comparison.pair.value, comparison.metric.split(".")[0]


def _how_bad(comparison: Comparison) -> tuple[int, float]:
    share = abs(comparison.difference) / comparison.tolerance if comparison.tolerance > 0 else 0.0
    return WORST_LAST.index(comparison.verdict), share


def _row(scene: SceneResult, observation: ObservationResult, worst: Comparison) -> dict[str, Any]:
    number, _, part = worst.metric.partition(".")
    allowed = sum(each.amount for each in worst.tolerance_parts if each.source in ("certificate", "resolution"))
    low, high = worst.interval.low, worst.interval.high
    return {
        "phenomenon": observation.phenomenon.value,
        "scene": scene.name,
        "observation": observation.name,
        "pair": worst.pair.value,
        "metric": number,
        "part": part,
        "unit": worst.unit,
        "difference": worst.difference,
        "low": low,
        "high": high,
        "certificate": allowed,
        "tolerance": worst.tolerance,
        "beyond": max(0.0, low - allowed, -high - allowed),
        "verdict": worst.verdict.value,
        "cause": worst.attribution.cause.value if worst.attribution and worst.verdict is Verdict.DEVIATES else "",
    }


def _grouped(rows: Iterable[dict[str, Any]]) -> Iterable[list[dict[str, Any]]]:
    """The rows of one number of one phenomenon in one pair; they must be sorted."""
    for _, group in groupby(rows, key=lambda row: (row["phenomenon"], row["pair"], row["metric"])):
        yield list(group)


def _summary(group: list[dict[str, Any]]) -> dict[str, Any]:
    """One number over all scenes: how often each verdict fell, the middle of its differences, and the largest."""
    largest = max(group, key=lambda row: abs(row["difference"]))
    return {
        **{key: group[0][key] for key in ("phenomenon", "pair", "metric", "unit")},
        "rows": len(group),
        "verdicts": {verdict.value: sum(row["verdict"] == verdict.value for row in group) for verdict in WORST_LAST},
        "beyond": sum(row["beyond"] > 0 for row in group),
        "median": median(abs(row["difference"]) for row in group),
        "largest": largest,
    }
