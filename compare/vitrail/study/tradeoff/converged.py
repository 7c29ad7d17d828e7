"""Where no formula knows a scene, a converged rendering by the tracer stands for the truth; its own error is stated.

Two renderings are made that share nothing but the scene: another seed, and half the gather radius, so that noise and
the blur of the disc both part them. The first is the reference; what the second differs from it, measured like any
setting, is the reference's own error. No price below that error can be stated.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from vitrail.base.scratch import scratch
from vitrail.engines.tracer import Tracer
from vitrail.images.exr import ImageLayers, read_image
from vitrail.pipeline.job import Job, prepare
from vitrail.pipeline.run import run
from vitrail.pipeline.task import Task
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash
from vitrail.study.tradeoff.knobs import Extent

SAMPLES: Mapping[Extent, int] = {"quick": 16, "normal": 64, "wide": 256}
PHOTONS: Mapping[Extent, int] = {"quick": 2_000_000, "normal": 10_000_000, "wide": 40_000_000}
RADII = {"reference": 0.5, "second": 0.25}
"""Gather radius of both renderings over the one the budget would choose for their photons."""


@dataclass(frozen=True)
class Converged:
    """The two renderings of one scene at one extent, kept in ``folder`` and made when they are first asked for."""

    loaded: Loaded
    extent: Extent
    build: str
    folder: Path
    lock: threading.Lock

    @property
    def task(self) -> Task:
        """The task that measures the reference's own error; its key names the reference."""
        spec = {"scene": scene_hash(self.loaded.scene), "build": self.build, "settings": self._settings_record()}
        return Task("reference", {"engine": "tracer", **spec})

    def _settings_record(self) -> dict[str, dict[str, float]]:
        """What decides the two images, for the key and for a reader."""
        return {
            name: {"samples": each.samples, "photons": each.photons, "gather_radius_m": each.gather_radius_m}
            for name, each in ((name, self._job(name).settings) for name in RADII)
        }

    def image(self, which: str) -> ImageLayers:
        """``reference`` or ``second``; rendered once, whoever asks first, and kept under the key of the task."""
        kept = self.folder / f"{self.task.key}.{which}.exr"
        with self.lock:
            if not kept.is_file():
                self._render(self._job(which), kept)
            return read_image(kept)

    def _job(self, which: str) -> Job:
        work: dict[str, object] = {"samples": SAMPLES[self.extent], "seed": 1001 if which == "reference" else 1002}
        usual = prepare(self.loaded, Quality.REFERENCE, work)
        if usual.settings.photons == 0:
            return usual
        work["photons"] = PHOTONS[self.extent]
        usual = prepare(self.loaded, Quality.REFERENCE, work)
        radius_m = usual.settings.gather_radius_m * RADII[which]
        return prepare(self.loaded, Quality.REFERENCE, {**work, "gather_radius_m": radius_m})

    def _render(self, job: Job, kept: Path) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        with scratch(".rendering-", self.folder) as work:
            os.replace(run(job, Tracer(), work).image_path, kept)
