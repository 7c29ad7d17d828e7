"""The numbers of one scene's images: between the engines, against closed forms, and against its stored image."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from vitrail.images.coarser import coarser
from vitrail.images.exr import ImageLayers
from vitrail.judge.common_random_numbers import with_common_noise
from vitrail.judge.comparison import Pair
from vitrail.judge.observe import Observed, merged, observe
from vitrail.judge.records import GlobalMetric
from vitrail.judge.references import read_scene_truth
from vitrail.judge.shown import Shown
from vitrail.judge.stored import Stored
from vitrail.judge.thresholds import thresholds_of
from vitrail.judge.whole_image import global_metrics
from vitrail.plan.settings import Settings
from vitrail.scene.model import Scene

PAIRS = (Pair.TRACER_POVRAY, Pair.TRACER_TRUTH, Pair.POVRAY_TRUTH)


@dataclass(frozen=True)
class Measurements:
    """One scene, its images by side, what was made for single observations, and what all may be held against.

    ``times`` is how many pixels the images have for one that the scene says, along an edge.
    """

    scene: Scene
    name: str
    references: Path
    settings: Settings
    images: Mapping[str, ImageLayers]
    stored: Stored | None
    views: Mapping[str, Shown] = field(default_factory=dict)
    times: int = 1

    def observations(self) -> tuple[Observed, ...]:
        """Every observation on every pair. Raises NothingToMeasure."""
        truth = read_scene_truth(self.references, self.name, self.scene)
        radius_m = self.settings.gather_radius_m
        found = observe(self.scene, self.images, PAIRS, truth, radius_m, self.views)
        if self.stored is None:
            return found
        older = observe(self.scene, self._with_stored(), (Pair.TRACER_STORED,), truth, radius_m)
        return tuple(merged(*both) for both in zip(found, older, strict=True))

    def whole_images(self) -> tuple[GlobalMetric, ...]:
        """Global metrics between the engines, and against the stored image, where they are judged too."""
        stops = self.scene.image.exposure_stops
        images = {side: coarser(image, self.times) for side, image in self.images.items()}
        found = global_metrics(Pair.TRACER_POVRAY, images, stops)
        if self.stored is None:
            return found
        rules = thresholds_of(self.references).stored_image
        return found + global_metrics(Pair.TRACER_STORED, self._with_stored(), stops, rules)

    def _with_stored(self) -> dict[str, ImageLayers]:
        """The tracer's image and its stored one; made by one recipe they share their noise, and the halves say so."""
        assert self.stored is not None
        tracer, stored = self.images["tracer"], self.stored.image
        if dict(self.stored.provenance.settings) == self.settings.as_record():
            tracer, stored = with_common_noise(tracer, stored)
        return {"tracer": tracer, "stored": stored}
