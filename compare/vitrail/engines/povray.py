"""POV-Ray as an engine: every run of a lowered scene inside walls, its statistics checked, its images added up."""

from __future__ import annotations

import os
import shutil
import tempfile
import threading
import time
from concurrent.futures import Executor, ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np

from vitrail.base.progress import Progress, silent
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.engines.child import Finished, Limits, run_child
from vitrail.engines.isolate import Allowance, isolate
from vitrail.engines.photon_file import PhotonFileError, fluxes_of, order_photon_file, write_dark_photon
from vitrail.engines.povray_command import IMAGE, picture_command
from vitrail.engines.povray_output import complaint_of, progress_of, statistics_of, version_of
from vitrail.engines.povray_result import Execution, Outcome, PhotonCensus, write_result
from vitrail.images.exr import ImageError, read_image, write_image
from vitrail.lower.povray import PovrayRun, PovrayScene
from vitrail.lower.povray.photons.photons import PHOTON_FILE
from vitrail.lower.povray.text.sky import SkyPicture

OLDEST = (3, 7)
TIMEOUT_S = 3600.0
EXTRA_MEMORY_BYTES = 1 << 30
"""Address space beyond the memory limit: the program itself, its libraries and its reserved stacks."""
INSTALL = "install POV-Ray 3.7, on Debian with `apt-get install povray`"
DEFECT = "this is a defect of the translation or of POV-Ray; its words follow"


class Povray:
    """POV-Ray as an engine. ``program`` is a name or a path; ``timeout_s`` is for one execution."""

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
        if finished.timed_out:
            raise EngineFailure(
                self.name, f"asked for its version, it {finished.ending()}", INSTALL, complaint_of(said)
            )
        found = version_of(said)
        if found is None:
            raise EngineFailure(self.name, "it does not say its version", INSTALL, complaint_of(said))
        if found[:2] < OLDEST:
            raise EngineFailure(self.name, f"version {found[2]} is older than 3.7", INSTALL, complaint_of(said))
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
            try:
                outcomes = self._outcomes(lowered, shown, pool)
            except BaseException:
                # Let no other run go on for a result that nobody will see.
                shown.stop.set()
                pool.shutdown(cancel_futures=True)
                raise
        self._check_photons(outcomes)
        return write_result(out_dir, lowered, outcomes, version, at_once, time.monotonic() - started)

    def _outcomes(self, lowered: PovrayScene, shown: _SharedProgress, pool: Executor) -> list[Outcome]:
        """Every run; those with the same texts are executed once, because they would give the same bits."""
        firsts = {_work(run): run for run in reversed(lowered.runs)}
        found = dict(zip(firsts, pool.map(lambda run: self._run(run, lowered, shown), firsts.values()), strict=True))
        return [
            found[_work(run)] if run is firsts[_work(run)] else replace(found[_work(run)], run=run, is_repeated=True)
            for run in lowered.runs
        ]

    def _run(self, run: PovrayRun, lowered: PovrayScene, shown: _SharedProgress) -> Outcome:
        """One run in a fresh folder: shoot photons and put their map in order, then render with it."""
        with tempfile.TemporaryDirectory(prefix="vitrail-povray-") as name:
            folder = Path(name)
            if run.sky is not None:
                self._write_sky(folder, run.sky)
            census = None
            if run.photon_sdl is not None:
                shot = self._execute(run.photon_sdl, 1, 1, folder, lowered, shown, run.name)
                census = self._census(shot, folder / PHOTON_FILE)
            done = self._execute(run.sdl, run.width, run.height, folder, lowered, shown, run.name)
            image = self._image(folder / IMAGE, run, done.output)
        self._check_depth(run, done)
        return Outcome(run, image, done, census)

    def _write_sky(self, folder: Path, sky: SkyPicture) -> None:
        try:
            write_image(folder / sky.name, sky.pixels, pixel_type="half")
        except ImageError as error:
            remedy = "free room there, or name another folder in TMPDIR"
            raise EngineFailure(self.name, f"what it is to see as sky cannot be written ({error})", remedy) from None

    def _execute(
        self, sdl: str, width: int, height: int, folder: Path, lowered: PovrayScene, shown: _SharedProgress, run: str
    ) -> Execution:
        """Start POV-Ray once; raises EngineFailure unless it ends well."""
        memory_bytes = (int(lowered.settings.memory_limit_mb) << 20) + EXTRA_MEMORY_BYTES
        isolated = picture_command(self.program, sdl, width, height, folder, memory_bytes)
        said: list[str] = []
        finished = run_child(
            isolated.command,
            limits=Limits(wall_s=self._timeout_s),
            on_line=lambda line: shown.hear(run, line, said),
            stop=shown.stop,
        )
        output = "\n".join(said)
        self._check_ending(finished, output)
        return Execution(finished, output, statistics_of(output), isolated.walls)

    def _check_ending(self, finished: Finished, output: str) -> None:
        if finished.timed_out:
            remedy = "lower the number of photons or samples, or raise the time limit"
            raise EngineFailure(self.name, f"it {finished.ending()}", remedy, complaint_of(output))
        if finished.code != 0:
            raise EngineFailure(self.name, f"it {finished.ending()}", DEFECT, complaint_of(output))

    def _census(self, shot: Execution, path: Path) -> PhotonCensus:
        """Order the photon map and count it.

        Without a single photon POV-Ray writes no map, and would let light straight through glass [P 12.2]: a band or a
        channel whose light goes elsewhere gets a photon without light instead.
        """
        if not path.is_file():
            write_dark_photon(path)
            return PhotonCensus(shot, 0, np.zeros(3), 0.0)
        started = time.thread_time()
        try:
            photons = order_photon_file(path)
        except PhotonFileError as error:
            raise EngineFailure(self.name, str(error), DEFECT, complaint_of(shot.output)) from None
        return PhotonCensus(shot, len(photons), fluxes_of(photons).sum(axis=0), time.thread_time() - started)

    def _check_photons(self, outcomes: list[Outcome]) -> None:
        """Photons that lost their light, or their way to the file, are a plausible, wrong picture [P 12.1, 12.2].

        That none arrives anywhere is no fault by itself: their light may leave the scene.
        """
        found = [outcome.census for outcome in outcomes if outcome.census is not None]
        stored = sum(max(census.stored, census.shot.statistics.photons_stored) for census in found)
        if stored and not any(census.flux.any() for census in found):
            what = f"it stored {stored} photons and saved none with light, so the picture would have no caustic"
            raise EngineFailure(self.name, what, DEFECT, complaint_of(found[0].shot.output))

    def _image(self, path: Path, run: PovrayRun, output: str) -> np.ndarray:
        """The run's image, (height, width, 3); raises EngineFailure when it is missing or not what was asked for."""
        remedy = "check disk space and the limits on file size; its words follow"
        if not path.is_file() or path.stat().st_size == 0:
            raise EngineFailure(self.name, "it ended well but wrote no image", remedy, complaint_of(output))
        try:
            image = read_image(path).radiance
        except ImageError as error:
            what = f"its image cannot be read ({error})"
            raise EngineFailure(self.name, what, remedy, complaint_of(output)) from None
        if image.shape != (run.height, run.width, 3):
            what = f"it wrote {image.shape[1]} x {image.shape[0]} pixels instead of {run.width} x {run.height}"
            raise EngineFailure(self.name, what, DEFECT, complaint_of(output))
        return image

    def _check_depth(self, run: PovrayRun, done: Execution) -> None:
        """A path cut short is black without a word [P 4.3]."""
        statistics = done.statistics
        if run.depth_is_proven and statistics.deepest_level >= statistics.level_limit > 0:
            what = f"rays reached the limit of {statistics.level_limit} levels, which the plan proves unreachable"
            raise EngineFailure(self.name, what, "this is a defect of the plan; report the scene")


def _work(run: PovrayRun) -> tuple[object, ...]:
    """What an execution depends on."""
    return (run.photon_sdl, run.sdl, run.width, run.height)


class _SharedProgress:
    """Adds the progress of runs that go on together, and ends them together."""

    def __init__(self, progress: Progress, lowered: PovrayScene) -> None:
        self._progress = progress
        works = {_work(run): run for run in lowered.runs}
        self._total = float(sum(run.width * run.height for run in works.values()))
        self._done: dict[str, int] = {}
        self.stop = threading.Event()

    def hear(self, run: str, line: str, said: list[str]) -> bool:
        """Use every line: progress moves the bar, the rest is kept."""
        found = progress_of(line)
        if found is None:
            said.append(line)
        else:
            self._done[run] = found[0]
            self._progress("povray", float(sum(self._done.values())), self._total)
        return True
