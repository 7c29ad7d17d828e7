"""The scenes that mutants are put into, and what they give without any."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from vitrail.judge.records import Results, SceneResult
from vitrail.lower.povray import NothingToEdit
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.compare import compare_scene
from vitrail.pipeline.content_keys import povray_key, tracer_key
from vitrail.pipeline.defect import Defect
from vitrail.pipeline.judge import judge
from vitrail.pipeline.lowered import job_of, lower
from vitrail.pipeline.request import Request
from vitrail.pipeline.scene_run import SceneRun, SceneTask
from vitrail.scene.load import Loaded, load
from vitrail.study.mutants.records import Alarm

FEWER: Mapping[str, object] = {"photons": 200_000}
"""Where POV-Ray takes 10 s and more at the photons of normal quality, and a fifth of them leave 0.1 % of noise."""

BENCH: Mapping[str, Mapping[str, object]] = {
    "conformance/camera": {},
    "calibration/grey_card_directional": {},
    "calibration/grey_card_point": {},
    "calibration/penumbra": {},
    "calibration/ambient_card": {},
    "calibration/mirror": {},
    "calibration/slab_clear": {},
    "calibration/slab_tilted": {},
    "calibration/reflecting_prism": {},
    "calibration/tinted_pane_seen": {},
    "calibration/tinted_pane_projected": FEWER,
    "calibration/beer_wedge": {},
    "calibration/frosted_edge": {},
    "calibration/prism_screen": FEWER,
    "calibration/ball_lens": {},
}
"""At least one scene a phenomenon, with the settings that are not those of normal quality."""

ALONE: Mapping[str, tuple[float, str]] = {
    "ssim": (0.95, "below"),
    "flip": (0.05, "above"),
    "relmse": (0.01, "above"),
}
"""Customary thresholds on whole images: what one number over the picture would have said."""


@dataclass(frozen=True)
class Bench:
    """The scenes with their clean results; ``requests`` hold their settings, ``alarms`` what one number over a clean
    picture already calls different, by metric."""

    scenes: Mapping[str, Loaded]
    clean: Mapping[str, SceneRun]
    requests: Mapping[str, Request]
    alarms: Mapping[str, frozenset[str]]

    def judged(self, runs: Mapping[str, SceneRun]) -> Results:
        return judge([runs[name] for name in self.scenes], about_run((), 0))

    def touched(self, defect: Defect) -> list[str]:
        """The scenes whose lowered form a defect changes."""
        return [name for name in self.scenes if self._is_touched(name, defect)]

    def _is_touched(self, name: str, defect: Defect) -> bool:
        loaded, request = self.scenes[name], self.requests[name]
        try:
            return content(loaded, replace(request, defect=defect)) != content(loaded, request)
        except NothingToEdit:
            return False


def clean_bench(folder: Path, out: Path) -> Bench:
    """Every scene of the bench without any defect; ``folder`` holds the folders of scenes."""
    scenes = {Path(name).name: load(folder / f"{name}.yaml") for name in BENCH}
    requests = {Path(name).name: _request(out, own) for name, own in BENCH.items()}
    clean = {name: compare_scene(SceneTask(name, loaded, requests[name])) for name, loaded in scenes.items()}
    records = [run.record for run in clean.values()]
    alarms = {metric: frozenset(scene.name for scene in records if _is_far(scene, metric)) for metric in ALONE}
    return Bench(scenes, clean, requests, alarms)


def _request(out: Path, overrides: Mapping[str, object]) -> Request:
    """Pictures as large as the scenes say: nobody looks at these, and POV-Ray takes a third of the time."""
    return Request(out=out / "bench", overrides=overrides, picture_width=1)


def content(loaded: Loaded, request: Request) -> tuple[str, str]:
    """What decides both images of a scene."""
    lowered = lower(job_of(loaded, request), request)
    return tracer_key("", lowered.tracer), povray_key("", lowered.povray)


def alone(bench: Bench, scenes: list[SceneResult]) -> dict[str, Alarm]:
    """Whether each whole-image number would have stopped the run, and on which scenes.

    A scene on which it calls even the clean run different tells nothing, and is not counted.
    """
    return {
        metric: Alarm(caught=bool(told), scenes=told)
        for metric in ALONE
        for told in [
            tuple(scene.name for scene in scenes if scene.name not in bench.alarms[metric] and _is_far(scene, metric))
        ]
    }


def _is_far(scene: SceneResult, metric: str) -> bool:
    threshold, side = ALONE[metric]
    values = [entry.value for entry in scene.global_metrics if entry.metric == metric]
    return any(value < threshold if side == "below" else value > threshold for value in values)
