"""POV-Ray as an engine: every run of a lowered scene inside walls, its images added up, its statistics checked."""

from __future__ import annotations

import json
import math
import os
import shutil
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from vitrail.engines.base import EngineFailure, Progress, Rendering, silent
from vitrail.engines.child import Finished, Limits, run_child
from vitrail.engines.isolate import Allowance, isolate
from vitrail.engines.povray_output import Statistics, complaint_of, progress_of, statistics_of, version_of
from vitrail.images.exr import ImageError, read_image, write_image
from vitrail.lower.canonical_json import canonical_json
from vitrail.lower.povray import PovrayRun, PovrayScene

OLDEST = (3, 7)
TIMEOUT_S = 3600.0
INSTALL = "install POV-Ray 3.7, on Debian with `apt-get install povray`"


@dataclass(frozen=True)
class _Outcome:
    """One finished run: its image (height, width, 3), what POV-Ray counted, and what it used."""

    run: PovrayRun
    image: np.ndarray
    statistics: Statistics
    finished: Finished
    walls: tuple[str, ...]


class Povray:
    """POV-Ray as an engine. ``program`` is a name or a path; ``timeout_s`` is for one run."""

    name = "povray"

    def __init__(self, program: str = "povray", timeout_s: float = TIMEOUT_S) -> None:
        self._named, self._timeout_s = program, timeout_s
        self._version = ""

    @property
    def program(self) -> Path:
        """Where POV-Ray is; raises EngineFailure when it is nowhere."""
        found = shutil.which(self._named)
        if found is None:
            raise EngineFailure(self.name, f"there is no program `{self._named}`", INSTALL)
        return Path(found)

    def version(self) -> str:
        """POV-Ray's version, such as ``3.7.0.10.unofficial``; raises EngineFailure when it is missing or too old."""
        if self._version:
            return self._version
        with tempfile.TemporaryDirectory(prefix="vitrail-povray-") as folder:
            isolated = isolate(self.program, ["--version"], Path(folder), Allowance(cpu_s=60))
            finished = run_child(isolated.command, limits=Limits(wall_s=min(60.0, self._timeout_s)))
        said = finished.stdout + finished.said
        found = version_of(said)
        if finished.timed_out or found is None:
            what = (
                "it does not say its version"
                if not finished.timed_out
                else f"asked for its version, it {finished.ending()}"
            )
            raise EngineFailure(self.name, what, INSTALL, complaint_of(said))
        if found[:2] < OLDEST:
            raise EngineFailure(
                self.name, f"version {found[2]} is older than 3.7", INSTALL, said.strip().splitlines()[0]
            )
        self._version = found[2]
        return self._version

    def render(
        self, lowered: PovrayScene, out_dir: Path, *, threads: int = 0, progress: Progress = silent
    ) -> Rendering:
        """Render into ``out_dir``: povray.exr, povray.run.json and the scene texts in ``povray/``.

        Each run has one thread, because photons differ with the number of threads [P 6]; ``threads`` runs go on at a
        time (0: one a core). Files appear whole or not at all. Raises EngineFailure.
        """
        version, started = self.version(), time.monotonic()
        at_once = min(threads or os.cpu_count() or 1, len(lowered.runs))
        shown = _SharedProgress(progress, lowered)
        with ThreadPoolExecutor(at_once) as pool:
            outcomes = list(pool.map(lambda run: self._run(run, lowered, shown), lowered.runs))
        out_dir.mkdir(parents=True, exist_ok=True)
        record = _record(version, lowered, outcomes, at_once, time.monotonic() - started)
        for run in lowered.runs:
            _write_text(out_dir / "povray" / f"{run.name}.pov", run.sdl)
        image = _write_image(out_dir / "povray.exr", lowered, outcomes, version)
        _write_text(out_dir / "povray.run.json", canonical_json(record))
        return Rendering(image, record)

    def _run(self, run: PovrayRun, lowered: PovrayScene, shown: _SharedProgress) -> _Outcome:
        """One execution in a fresh folder."""
        with tempfile.TemporaryDirectory(prefix="vitrail-povray-") as name:
            folder = Path(name)
            (folder / "scene.pov").write_text(run.sdl, encoding="ascii")
            memory = int(lowered.settings.memory_limit_mb) << 20
            isolated = isolate(self.program, _arguments(run), folder, Allowance(memory_bytes=memory + (1 << 30)))
            limits = Limits(wall_s=self._timeout_s)
            # Keep what POV-Ray says as it comes: statistics and complaints are read from it afterwards.
            said: list[str] = []
            finished = run_child(isolated.command, limits=limits, on_line=lambda line: shown.hear(run.name, line, said))
            output = "\n".join(said)
            if finished.interrupted:
                raise KeyboardInterrupt
            self._check_ending(finished, output)
            image = self._image(folder / "image.exr", run, output)
        statistics = statistics_of(output)
        self._check_statistics(run, statistics, output)
        return _Outcome(run, image, statistics, finished, isolated.walls)

    def _check_ending(self, finished: Finished, output: str) -> None:
        if finished.timed_out:
            remedy = "lower the number of photons or samples, or raise the time limit"
            raise EngineFailure(self.name, f"it {finished.ending()}", remedy, complaint_of(output))
        if finished.code != 0:
            remedy = "this is a defect of the translation or of POV-Ray; its words follow"
            raise EngineFailure(self.name, f"it {finished.ending()}", remedy, complaint_of(output))

    def _image(self, path: Path, run: PovrayRun, output: str) -> np.ndarray:
        """The run's image, (height, width, 3); raises EngineFailure when it is missing or not what was asked for."""
        remedy = "check disk space and the limits on file size; its words follow"
        if not path.is_file() or path.stat().st_size == 0:
            raise EngineFailure(self.name, "it ended well but wrote no image", remedy, complaint_of(output))
        try:
            image = read_image(path).radiance
        except ImageError as error:
            raise EngineFailure(
                self.name, f"its image cannot be read ({error})", remedy, complaint_of(output)
            ) from None
        if image.shape != (run.height, run.width, 3):
            what = f"it wrote {image.shape[1]} x {image.shape[0]} pixels instead of {run.width} x {run.height}"
            raise EngineFailure(self.name, what, remedy, complaint_of(output))
        return image

    def _check_statistics(self, run: PovrayRun, statistics: Statistics, output: str) -> None:
        """An empty photon map gives a plausible, wrong picture [P 12.2], and so does a path cut short."""
        if run.expects_photons and statistics.photons_stored == 0:
            what = f"it shot {statistics.photons_shot} photons and stored none, so the picture has no caustic"
            raise EngineFailure(self.name, what, "check that light reaches the glass and a surface behind it")
        if run.depth_is_proven and statistics.deepest_level >= statistics.level_limit > 0:
            what = f"rays reached the limit of {statistics.level_limit} levels, which the plan proves unreachable"
            raise EngineFailure(self.name, what, "this is a defect of the plan; report the scene")


class _SharedProgress:
    """Adds the progress of runs that go on together."""

    def __init__(self, progress: Progress, lowered: PovrayScene) -> None:
        self._progress = progress
        self._total = float(sum(run.width * run.height for run in lowered.runs))
        self._done: dict[str, int] = {}

    def hear(self, run: str, line: str, said: list[str]) -> bool:
        """Use every line: progress moves the bar, the rest is kept."""
        found = progress_of(line)
        if found is None:
            said.append(line)
        else:
            self._done[run] = found[0]
            self._progress("povray", float(sum(self._done.values())), self._total)
        return True


def _arguments(run: PovrayRun) -> list[str]:
    """One thread, no antialiasing of its own, linear half-float output."""
    return ["+Iscene.pov", "+Oimage.exr", f"+W{run.width}", f"+H{run.height}", "+FE", "-D", "-A", "+WT1"]


def _averaged(outcome: _Outcome) -> np.ndarray:
    """The run's image at the scene's size, times its gain."""
    across = outcome.run.samples_across
    height, width = outcome.image.shape[0] // across, outcome.image.shape[1] // across
    blocks = outcome.image.reshape(height, across, width, across, 3).mean(axis=(1, 3))
    return blocks * np.array(outcome.run.gain)


def _write_image(path: Path, lowered: PovrayScene, outcomes: list[_Outcome], version: str) -> Path:
    """Both halves, their mean and the variance of the mean, (a - b)^2 / 4."""
    halves = {
        half: sum(_averaged(outcome) for outcome in outcomes if outcome.run.half == half)
        for half in dict.fromkeys(outcome.run.half for outcome in outcomes)
    }
    a, b = (np.asarray(half) for half in halves.values())
    metadata = {
        "vitrail:scene_hash": lowered.scene_hash,
        "vitrail:engine": f"POV-Ray {version}",
        "vitrail:settings": json.dumps(_settings(lowered, outcomes), sort_keys=True),
    }
    partial = path.with_name(f".{path.name}.partial.exr")
    write_image(partial, (a + b) / 2, half_a=a, half_b=b, variance=(a - b) ** 2 / 4, metadata=metadata)
    os.replace(partial, path)
    return path


def _settings(lowered: PovrayScene, outcomes: list[_Outcome]) -> dict[str, Any]:
    """The settings asked for, and what became of them."""
    photons = lowered.photons
    across = lowered.runs[0].samples_across
    return {
        **asdict(lowered.settings),
        "mode": lowered.mode.name,
        "mode_reason": lowered.mode.reason,
        "samples_used": across**2 * len({run.half for run in lowered.runs}),
        "photons_used": sum(outcome.statistics.photons_shot for outcome in outcomes),
        "gather_radius_units": photons.gather_radius if photons else 0.0,
        "units_per_metre": lowered.normalisation.scale,
        "centre_m": list(lowered.normalisation.centre),
        "max_trace_level": lowered.runs[0].max_trace_level,
    }


def _record(
    version: str, lowered: PovrayScene, outcomes: list[_Outcome], threads: int, wall_s: float
) -> dict[str, Any]:
    """The run record of the contract, both engines alike."""

    def total(name: str) -> int:
        return sum(getattr(outcome.statistics, name) for outcome in outcomes)

    def cpu(phase: str) -> float:
        return math.fsum(outcome.statistics.cpu_s[phase] for outcome in outcomes)

    return {
        "vitrail_run": 1,
        "engine": "povray",
        "version": version,
        "scene_hash": lowered.scene_hash,
        "settings": _settings(lowered, outcomes),
        "threads": threads,
        "cpu_s": {
            "total": math.fsum(outcome.finished.cpu_s for outcome in outcomes),
            "build": cpu("parse") + cpu("bounding"),
            "photon_pass": cpu("photon"),
            "photon_sort": 0.0,
            "camera": cpu("trace"),
            "gather": 0.0,
        },
        "wall_s": wall_s,
        "peak_memory_bytes": max(outcome.finished.peak_memory_bytes for outcome in outcomes),
        "counters": {
            "camera_rays": total("rays"),
            "shadow_rays": total("shadow_tests"),
            "photons_emitted": total("photons_shot"),
            "photons_stored": total("photons_stored"),
            "gather_queries": total("gather_calls"),
        },
        "certificate": lowered.certificate.as_records(),
        "isolation": list(outcomes[0].walls),
        "runs": [_run_record(outcome) for outcome in outcomes],
        "warnings": _warnings(outcomes),
        "interrupted": False,
    }


def _run_record(outcome: _Outcome) -> dict[str, Any]:
    return {
        "name": outcome.run.name,
        "gain": list(outcome.run.gain),
        "statistics": asdict(outcome.statistics),
        "cpu_s": outcome.finished.cpu_s,
        "wall_s": outcome.finished.wall_s,
    }


def _warnings(outcomes: list[_Outcome]) -> list[str]:
    """Rays that met the limits of depth, where the scene itself sets them."""
    cut = [outcome for outcome in outcomes if outcome.statistics.deepest_level >= outcome.statistics.level_limit > 0]
    if not cut:
        return []
    return [
        f"camera rays reached the scene's limit of {cut[0].statistics.level_limit} levels; what lies deeper is black"
    ]


def _write_text(path: Path, text: str) -> None:
    """Whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.partial")
    partial.write_text(text, encoding="utf-8")
    os.replace(partial, path)
