"""How well an image knows its own numbers: for each observation and metric the noise, from the two halves, and the blur
of the gather disc; nothing else is needed, no other image and no formula.

The half width of the 95 % interval is that of every number of this program (``metrics.noise``), or what the independent
images of a mean scatter by, where that is more: the law of ``metrics.noise`` takes noise as alike over a few pixels
only, and a sum over a whole patch scatters up to twice as far where pixels have few samples or discs few photons.

Blur is no noise, and both halves share it; ``metrics.smoothing`` says how it is known. Pixels blur too, whatever the
passes: that is told apart, because only a larger image lessens it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy.special import stdtrit

from vitrail.images.exr import ImageLayers
from vitrail.images.patch import PatchGrid, PatchSamples, make_grid
from vitrail.judge.observe import context_of
from vitrail.judge.references import SceneTruth
from vitrail.judge.shown import Shown
from vitrail.judge.thresholds import Thresholds
from vitrail.metrics.by_phenomenon import measure, measure_with_intervals
from vitrail.metrics.measurement import Context, Measurement, MetricError
from vitrail.metrics.smoothing import gathered_again, pixelled_again
from vitrail.scene.model import Observation, Scene

LEVEL = 0.95

SAFETY = 1.5
"""What the first smoothing did over what the second does. In the caustic of a ball lens, made of beams without noise,
it is 1.3 in the innermost ring, with pixels of 1/60 and of 1/180 of the patch, and 1.0 to 1.6 in the next."""

FEWEST = 4
"""Images whose scatter says something: of three, Student's interval is 1.6 times as wide as of many, of two 2.2."""


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


@dataclass(frozen=True)
class Scatter:
    """How far independent images move each number, by ``key_of``: the sum of squares over ``count`` of them."""

    count: int = 0
    squares: Mapping[str, float] = field(default_factory=dict)

    def with_moves(self, moves: Mapping[str, float]) -> Scatter:
        """One image more; a number that one of them does not yield is not known from here on."""
        known = moves if self.count == 0 else {key: moves[key] for key in self.squares if key in moves}
        return Scatter(self.count + 1, {key: self.squares.get(key, 0.0) + move**2 for key, move in known.items()})

    def half_width(self, key: str) -> float:
        """Half the interval of the number in the mean of the images; 0 where they are too few to say."""
        if self.count < FEWEST or key not in self.squares:
            return 0.0
        error = math.sqrt(self.squares[key]) / self.count
        return float(stdtrit(self.count, 0.5 + LEVEL / 2)) * error


def key_of(observation: str, metric: str) -> str:
    return f"{observation}: {metric}"


@dataclass(frozen=True)
class Observer:
    """What a scene observes, asked of one image after the other. ``correlation_m`` is their largest gather radius."""

    scene: Scene
    truth: SceneTruth
    thresholds: Thresholds
    correlation_m: float

    @cached_property
    def _grids(self) -> dict[str, PatchGrid]:
        return {each.name: make_grid(self.scene.camera, self.scene.image, each.patch) for each in self.scene.observe}

    def errors(
        self,
        image: ImageLayers,
        scatter: Scatter,
        *,
        blur_radius_m: float,
        phenomena: frozenset[str] | None = None,
    ) -> tuple[HalfError, ...]:
        """The errors of all that the scene observes, or of some phenomena.

        ``blur_radius_m`` is the root of the mean square gather radius, 0 where nothing is gathered. A number that comes
        and goes with the noise is not known at all: its error is infinite. Raises ThresholdError.
        """
        found: list[HalfError] = []
        for entry in self.scene.observe:
            if phenomena is None or entry.phenomenon.value in phenomena:
                found += self._of_patch(entry, self._samples(entry, image), scatter, blur_radius_m)
        return tuple(found)

    def moves(self, image: ImageLayers, noise: np.ndarray) -> dict[str, float]:
        """What every number of ``image`` changes by when ``noise`` (height, width, 3) is added to it."""
        moves: dict[str, float] = {}
        for entry in self.scene.observe:
            samples, context = self._samples(entry, image), self._context(entry)
            before = _numbers(entry, samples, context)
            after = _numbers(entry, samples.disturbed(self._grids[entry.name].apply(noise)), context)
            moves |= {key_of(entry.name, name): after[name] - before[name] for name in before if name in after}
        return moves

    def _of_patch(
        self, entry: Observation, samples: PatchSamples, scatter: Scatter, blur_radius_m: float
    ) -> list[HalfError]:
        context = self._context(entry)
        try:
            found = measure_with_intervals(entry.phenomenon, samples, None, context, level=LEVEL)
        except MetricError:
            return []
        half_edge_m = min(math.hypot(*entry.patch.u), math.hypot(*entry.patch.v))
        known = {each.metric for each in self.truth.of(entry.name)}
        blurred = _numbers(entry, gathered_again(samples, blur_radius_m), context) if blur_radius_m > 0 else {}
        pixelled = _numbers(entry, pixelled_again(samples), context)
        return [
            HalfError(
                observation=entry.name,
                phenomenon=entry.phenomenon.value,
                metric=each.metric,
                value=float(each.value),
                unit=each.unit,
                half_width=max(_half_width(each), scatter.half_width(key_of(entry.name, each.metric))),
                blur=SAFETY * abs(blurred.get(each.metric, each.value) - each.value),
                pixel_blur=SAFETY * abs(pixelled.get(each.metric, each.value) - each.value),
                scale=self.thresholds.rule(entry.phenomenon, each.metric).size(each.value, half_edge_m),
                meant=not known or each.metric in known,
            )
            for each in found
        ]

    def _samples(self, entry: Observation, image: ImageLayers) -> PatchSamples:
        return Shown.by_scene(self.scene, {"": image}).samples("", entry.patch, self._grids[entry.name])

    def _context(self, entry: Observation) -> Context:
        return context_of(self.scene, entry, self.truth, self.correlation_m)


def _half_width(measurement: Measurement) -> float:
    interval = measurement.interval
    return math.inf if interval is None else (interval.high - interval.low) / 2


def _numbers(entry: Observation, samples: PatchSamples, context: Context) -> dict[str, float]:
    """Every number of a patch; none where nothing can be measured on it."""
    try:
        return {each.metric: float(each.value) for each in measure(entry.phenomenon, samples, None, context)}
    except MetricError:
        return {}
