"""Whole-image numbers for the record: shown beside the verdicts, since people ask, and never one themselves."""

from __future__ import annotations

from collections.abc import Mapping

from vitrail.images.display import Display
from vitrail.images.exr import ImageLayers
from vitrail.judge.plain import plain
from vitrail.judge.records import GlobalMetric
from vitrail.metrics.measurement import MetricError
from vitrail.metrics.whole_image import measure_image


def global_metrics(images: Mapping[str, ImageLayers], exposure_stops: float) -> tuple[GlobalMetric, ...]:
    """SSIM, multi-scale SSIM, FLIP, relative errors and colour error of two images; nothing for any other number."""
    if len(images) != 2:
        return ()
    candidate, reference = images.values()
    try:
        found = measure_image(candidate, reference, Display(exposure_stops))
    except MetricError:
        return ()
    return tuple(
        GlobalMetric(
            metric=entry.metric,
            value=entry.value,
            unit=entry.unit,
            ideal=entry.ideal if entry.ideal is not None else 0.0,
            floor=entry.floor,
            settings=plain(entry.settings),
            parts=plain(entry.parts),
            caveats=entry.caveats,
        )
        for entry in found
    )
