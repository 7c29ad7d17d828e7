"""How well an image knows its own numbers: for each observation and metric the noise, from the two halves, and the blur
of the gather disc; nothing else is needed, no other image and no formula.

The half width of the 95 % interval is that of every number of this program (``metrics.noise``). Blur is no noise, and
both halves share it; ``judge.blur`` says how it is known. Pixels blur too, whatever the passes: that is told apart,
because only a larger image lessens it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.images.exr import ImageLayers
from vitrail.images.patch import PatchSamples, make_grid
from vitrail.judge.blur import SAFETY, gathered_again, pixelled_again
from vitrail.judge.observe import context_of, samples_of
from vitrail.judge.references import SceneTruth
from vitrail.judge.thresholds import Thresholds
from vitrail.metrics.by_phenomenon import measure, measure_with_intervals
from vitrail.metrics.measurement import Context, Measurement, MetricError
from vitrail.scene.model import Observation, Scene


@dataclass(frozen=True)
class HalfError:
    """One number of one observation. ``half_width``, ``blur`` and ``pixel_blur`` are in ``unit``.

    ``scale`` is what the threshold of the metric is relative to: the value, the half edge of the patch in metres, or 1.
    ``meant`` are the numbers that stand for the phenomenon: those that formulas know, where they know any of the
    observation, else all.
    """

    observation: str
    phenomenon: str
    metric: str
    value: float
    unit: str
    half_width: float
    blur: float
    pixel_blur: float
    scale: float
    meant: bool = True

    @property
    def error(self) -> float:
        """How far the number may be from what endless passes give it, relative to ``scale``."""
        return self._relative(self.half_width + self.blur)

    @property
    def pixel_error(self) -> float:
        """How far that may be from what endless pixels give it, relative to ``scale``."""
        return self._relative(self.pixel_blur)

    def _relative(self, doubt: float) -> float:
        return 0.0 if doubt == 0 else doubt / self.scale if self.scale > 0 else math.inf


def half_errors(
    scene: Scene,
    image: ImageLayers,
    truth: SceneTruth,
    thresholds: Thresholds,
    *,
    correlation_m: float,
    blur_radius_m: float,
    phenomena: frozenset[str] | None = None,
) -> tuple[HalfError, ...]:
    """The errors of all that the scene observes, or of some phenomena.

    ``correlation_m`` is the largest gather radius in the image, ``blur_radius_m`` the root of their mean square, 0
    where nothing is gathered. A number that comes and goes with the noise is not known at all: its error is infinite.
    Raises ThresholdError.
    """
    found: list[HalfError] = []
    for entry in scene.observe:
        if phenomena is not None and entry.phenomenon.value not in phenomena:
            continue
        samples = samples_of(scene, entry, image, make_grid(scene.camera, scene.image, entry.patch))
        context = context_of(scene, entry, truth, correlation_m)
        meant = {each.metric for each in truth.of(entry.name)}
        found += _of_patch(entry, samples, context, thresholds, blur_radius_m, meant)
    return tuple(found)


def _of_patch(
    entry: Observation,
    samples: PatchSamples,
    context: Context,
    thresholds: Thresholds,
    blur_radius_m: float,
    meant: set[str],
) -> list[HalfError]:
    try:
        found = measure_with_intervals(entry, samples, None, context)
    except MetricError:
        return []
    half_edge_m = min(math.hypot(*entry.patch.u), math.hypot(*entry.patch.v))
    blurred = _numbers(entry, gathered_again(samples, blur_radius_m), context) if blur_radius_m > 0 else {}
    pixelled = _numbers(entry, pixelled_again(samples), context)
    return [
        HalfError(
            observation=entry.name,
            phenomenon=entry.phenomenon.value,
            metric=each.metric,
            value=float(each.value),
            unit=each.unit,
            half_width=_half_width(each),
            blur=SAFETY * abs(blurred.get(each.metric, each.value) - each.value),
            pixel_blur=SAFETY * abs(pixelled.get(each.metric, each.value) - each.value),
            scale=thresholds.rule(entry.phenomenon, each.metric).size(each.value, half_edge_m),
            meant=not meant or each.metric in meant,
        )
        for each in found
    ]


def _half_width(measurement: Measurement) -> float:
    interval = measurement.interval
    return math.inf if interval is None else (interval.high - interval.low) / 2


def _numbers(entry: Observation, samples: PatchSamples, context: Context) -> dict[str, float]:
    """Every number of a patch; none where nothing can be measured on it."""
    try:
        return {each.metric: float(each.value) for each in measure(entry, samples, None, context)}
    except MetricError:
        return {}
