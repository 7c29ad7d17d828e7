"""How far the engines agree, phenomenon by phenomenon: the comparisons of finished runs, one row a number.

A number with several parts (channels, rings, positions) gives the row of the part that is worst off. ``certificate`` is
what the translation allows, in the unit of the number; ``beyond`` is how far the whole interval of the difference lies
outside of it, which the threshold of the metric may still forgive: such rows are findings, whatever their verdict.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby
from statistics import median
from typing import Literal

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record
from vitrail.judge.comparison import Comparison, ObservationResult, Pair, Verdict
from vitrail.judge.records import Results, SceneResult, Status

PAIRS = (Pair.TRACER_POVRAY, Pair.POVRAY_TRUTH)
"""The engines against each other, and POV-Ray against closed forms."""
WORST_LAST = (Verdict.AGREES, Verdict.INCONCLUSIVE, Verdict.DEVIATES)


class RunSettings(Record):
    """The settings that a reader needs to make a run again; null where the run does not name them."""

    quality: str | None = None
    samples: int | None = None
    photons: int | None = None
    gather_radius_m: float | None = None


class ScenePrice(Record):
    """What a reader needs to make the run of a scene again, and to see what it cost in CPU seconds by engine."""

    name: str
    status: Status
    scene_hash: str
    settings: RunSettings
    cpu_s: dict[str, float]


class AgreementRow(Record):
    """One number of one observation: its worst ``part``, in ``unit``; ``cause`` is empty where nothing deviates."""

    phenomenon: Phenomenon
    scene: str
    observation: str
    pair: Pair
    metric: str
    part: str
    unit: str
    difference: float
    low: float
    high: float
    certificate: float
    tolerance: float
    beyond: float
    verdict: Verdict
    cause: str


class AgreementSummary(Record):
    """One number over all scenes: how often each verdict fell, the middle of its differences, and the largest."""

    phenomenon: Phenomenon
    pair: Pair
    metric: str
    unit: str
    rows: int
    verdicts: dict[Verdict, int]
    beyond: int
    median: float
    largest: AgreementRow


class Agreement(Record):
    """``agreement.json.gz``."""

    vitrail_agreement: Literal[1] = 1
    scenes: tuple[ScenePrice, ...]
    rows: tuple[AgreementRow, ...]
    phenomena: tuple[AgreementSummary, ...]

    @property
    def beyond(self) -> list[AgreementRow]:
        """The rows that lie beyond what the certificate alone allows."""
        return [row for row in self.rows if row.beyond > 0]

    def count(self, verdict: Verdict) -> int:
        """How many rows have this verdict."""
        return sum(row.verdict == verdict for row in self.rows)


def agreement(runs: Sequence[Results]) -> Agreement:
    """Scenes and rows of several runs; a scene that is in more than one counts as the last run has it."""
    scenes = {scene.name: scene for run in runs for scene in run.scenes}
    rows = [row for scene in scenes.values() for row in _rows(scene)]
    rows.sort(key=lambda row: (row.phenomenon, row.pair, row.metric, row.scene, row.observation))
    return Agreement(
        scenes=tuple(_scene(scenes[name]) for name in sorted(scenes)),
        rows=tuple(rows),
        phenomena=tuple(_summary(group) for group in _grouped(rows)),
    )


def _scene(scene: SceneResult) -> ScenePrice:
    return ScenePrice(
        name=scene.name,
        status=scene.status,
        scene_hash=scene.scene_hash,
        settings=RunSettings(**{name: scene.settings.get(name) for name in RunSettings.model_fields}),
        cpu_s={engine.engine: round(engine.cpu_s, 1) for engine in scene.engines if engine.cpu_s is not None},
    )


def _rows(scene: SceneResult) -> Iterable[AgreementRow]:
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


def _row(scene: SceneResult, observation: ObservationResult, worst: Comparison) -> AgreementRow:
    number, _, part = worst.metric.partition(".")
    allowed = sum(each.amount for each in worst.tolerance_parts if each.source not in ("threshold", "reference"))
    low, high = worst.interval.low, worst.interval.high
    return AgreementRow(
        phenomenon=observation.phenomenon,
        scene=scene.name,
        observation=observation.name,
        pair=worst.pair,
        metric=number,
        part=part,
        unit=worst.unit,
        difference=worst.difference,
        low=low,
        high=high,
        certificate=allowed,
        tolerance=worst.tolerance,
        beyond=max(0.0, low - allowed, -high - allowed),
        verdict=worst.verdict,
        cause=worst.attribution.cause.value if worst.attribution and worst.verdict is Verdict.DEVIATES else "",
    )


def _grouped(rows: Iterable[AgreementRow]) -> Iterable[list[AgreementRow]]:
    """The rows of one number of one phenomenon in one pair; they must be sorted."""
    for _, group in groupby(rows, key=lambda row: (row.phenomenon, row.pair, row.metric)):
        yield list(group)


def _summary(group: list[AgreementRow]) -> AgreementSummary:
    first = group[0]
    return AgreementSummary(
        phenomenon=first.phenomenon,
        pair=first.pair,
        metric=first.metric,
        unit=first.unit,
        rows=len(group),
        verdicts={verdict: sum(row.verdict is verdict for row in group) for verdict in WORST_LAST},
        beyond=sum(row.beyond > 0 for row in group),
        median=median(abs(row.difference) for row in group),
        largest=max(group, key=lambda row: abs(row.difference)),
    )
