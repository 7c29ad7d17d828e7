"""The smallest defects that the verdicts must see: at full size each deviates, at half size it never agrees.

A verdict says nothing about defects that are smaller than its tolerance, so the tolerances follow from these four: a
caustic moved by 3 mm, a tint of 2 %, a spread that lost 5 %, a flux that is wrong by 1 %. They are put into the scene
that the tracer reads; POV-Ray reads the right one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from vitrail.base.record import write_record
from vitrail.judge.comparison import Comparison, Verdict
from vitrail.judge.records import SceneResult
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.compare import compare_scene
from vitrail.pipeline.defect import Defect
from vitrail.pipeline.judge import judge
from vitrail.pipeline.request import Request
from vitrail.pipeline.scene_run import SceneTask
from vitrail.scene.load import load
from vitrail.study.mutants import misreadings as misread
from vitrail.study.mutants.records import DetectionLimits, LimitNumber, LimitRow

SHARES = (0.0, 0.5, 1.0)
"""None of the defect, half of it, all of it."""

LENS_HEIGHT_M = 2.0
"""From the middle of the ball lens to the floor: what a turned sun turns the light about."""


@dataclass(frozen=True)
class Limit:
    """``misreading`` takes the size of the defect; ``families`` are the metrics that are about it."""

    name: str
    words: str
    size: float
    unit: str
    scene: str
    families: tuple[str, ...]
    misreading: Callable[[float], misread.Misreading]


def _tinted(share: float) -> misread.Misreading:
    """Glass that passes ``share`` more of the green light, through both of its faces together."""
    factor = math.sqrt(1 + share)
    return misread.glass(lambda m: {"transmission": (m.transmission[0], m.transmission[1] * factor, m.transmission[2])})


LIMITS = (
    Limit(
        "shift",
        "a caustic moved sideways",
        3.0,
        "mm",
        "ball_lens",
        ("centroid", "centroid_shift"),
        lambda size: misread.turned_sun(math.atan(1e-3 * size / LENS_HEIGHT_M)),
    ),
    Limit(
        "flux",
        "a caustic with too much light",
        1.0,
        "%",
        "ball_lens",
        ("caustic_flux", "flux_ratio"),
        lambda size: misread.brighter_suns(1 + size / 100),
    ),
    Limit(
        "tint",
        "a pane that is too green",
        2.0,
        "%",
        "tinted_pane_seen",
        ("transmittance", "radiance_ratio", "chromaticity_shift"),
        lambda size: _tinted(size / 100),
    ),
    Limit(
        "spread",
        "a spectrum that is too narrow",
        5.0,
        "%",
        "prism_screen",
        ("spread", "spread_ratio"),
        lambda size: misread.glass(misread.with_dispersion(1 - size / 100)),
    ),
)


def measure_limits(
    bench: Path, out: Path, *, limits: Sequence[Limit] = LIMITS, against: tuple[str, ...] = ("povray",)
) -> DetectionLimits:
    """Judge every limit at every share, each in a run of its own; write and return limits.json."""
    rows = tuple(_row(limit, share, bench, out, against) for limit in limits for share in SHARES)
    found = DetectionLimits(rows=rows, kept=all(is_kept(row) for row in rows))
    write_record(found, out / "limits.json")
    return found


def is_kept(row: LimitRow) -> bool:
    """Nothing agrees, half does not agree, all deviates: against every side there is."""
    agrees, open_, deviates = Verdict.AGREES, Verdict.INCONCLUSIVE, Verdict.DEVIATES
    wanted = {0.0: {agrees}, 0.5: {open_, deviates}, 1.0: {deviates}}[row.share]
    return bool(row.against) and all(number.verdict in wanted for number in row.against.values())


def _row(limit: Limit, share: float, bench: Path, out: Path, against: tuple[str, ...]) -> LimitRow:
    """One size of one defect: the number that sees it best, against POV-Ray and against the closed form."""
    defect = Defect(limit.name, misread_by_tracer=limit.misreading(share * limit.size)) if share else Defect()
    request = Request(out=out / "bench", against=against, defect=defect, picture_width=1)
    run = compare_scene(SceneTask(limit.scene, load(bench / f"{limit.scene}.yaml"), request))
    (scene,) = judge([run], about_run((), 0)).scenes
    pairs = {side: _clearest(scene, limit.families, f"tracer-vs-{side}") for side in (*against, "truth")}
    return LimitRow(
        name=limit.name,
        words=limit.words,
        size=share * limit.size,
        unit=limit.unit,
        share=share,
        scene=limit.scene,
        against={side: _number(entry) for side, entry in pairs.items() if entry is not None},
    )


def _clearest(scene: SceneResult, families: Sequence[str], pair: str) -> Comparison | None:
    """The comparison of these families that is furthest beyond its tolerance: it decides the verdict."""
    order = (Verdict.AGREES, Verdict.INCONCLUSIVE, Verdict.DEVIATES)
    found = [
        entry
        for observation in scene.observations
        for entry in observation.comparisons
        if entry.pair.value == pair and entry.metric.split(".")[0] in families
    ]
    return max(
        found,
        key=lambda entry: (order.index(entry.verdict), abs(entry.difference) / max(entry.tolerance, 1e-12)),
        default=None,
    )


def _number(entry: Comparison) -> LimitNumber:
    return LimitNumber(
        metric=entry.metric,
        unit=entry.unit,
        difference=entry.difference,
        ideal=entry.ideal,
        half_width=entry.interval.half_width,
        tolerance=entry.tolerance,
        verdict=entry.verdict,
    )
