"""Whole-image numbers for the record: shown beside the verdicts, since people ask, and never one themselves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vitrail.images.display import Display
from vitrail.images.exr import ImageLayers
from vitrail.judge.comparison import Pair, Verdict
from vitrail.judge.records import GlobalMetric
from vitrail.judge.rules import Rule
from vitrail.judge.to_json import to_json
from vitrail.metrics.measurement import Measurement, MetricError
from vitrail.metrics.whole_image import measure_image


def global_metrics(
    pair: Pair, images: Mapping[str, ImageLayers], exposure_stops: float, rules: Mapping[str, Rule] | None = None
) -> tuple[GlobalMetric, ...]:
    """SSIM, multi-scale SSIM, FLIP, relative errors and colour error of one pair; nothing where an image is missing.

    ``rules`` by metric judge a picture against an older one of our own; between programs no such number is judged.
    """
    candidate, reference = images.get(pair.candidate), images.get(pair.reference)
    if candidate is None or reference is None:
        return ()
    try:
        found = measure_image(candidate, reference, Display(exposure_stops))
    except MetricError:
        return ()
    return tuple(
        GlobalMetric(
            pair=pair,
            metric=entry.metric,
            value=entry.value,
            unit=entry.unit,
            ideal=entry.ideal if entry.ideal is not None else 0.0,
            floor=entry.floor,
            **_judged(entry, (rules or {}).get(entry.metric)),
            settings=to_json(entry.settings),
            parts=to_json(entry.parts),
            caveats=entry.caveats,
        )
        for entry in found
    )


def _judged(entry: Measurement, rule: Rule | None) -> dict[str, Any]:
    """Tolerance and verdict of one number: how far it is from what noise alone would give."""
    if rule is None:
        return {}
    expected = entry.floor if entry.floor is not None else entry.ideal
    is_near = expected is not None and abs(entry.value - expected) <= rule.amount
    return {"tolerance": rule.amount, "verdict": Verdict.AGREES if is_near else Verdict.DEVIATES}
