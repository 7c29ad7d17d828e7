"""One run of POV-Ray: photons shot once, then every picture that uses them, each execution in a folder of its own."""

from __future__ import annotations

import shutil
import signal
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vitrail.base.progress import Progress
from vitrail.base.scratch import scratch
from vitrail.engines.base import EngineFailure
from vitrail.engines.child import Finished, Limits, run_child
from vitrail.engines.photon_file import PhotonFileError, fluxes_of, order_photon_file, write_dark_photon
from vitrail.engines.povray_command import IMAGE, picture_command
from vitrail.engines.povray_output import complaint_of, progress_of, statistics_of
from vitrail.engines.povray_result import Drawn, Execution, Outcome, PhotonCensus
from vitrail.images.exr import ImageError, read_image, write_image
from vitrail.lower.povray import PovrayPicture, PovrayRun, PovrayScene
from vitrail.lower.povray.photons.photons import PHOTON_FILE
from vitrail.lower.povray.text.sky import SkyPicture

ENGINE = "povray"
DEFECT = "this is a defect of the translation or of POV-Ray; its words follow"
TOO_DEEP = "its stack may be too small for so many faces; lower max_transmissions or max_reflections; its words follow"
TOO_BRIGHT = "it may focus light to a point, which a larger `gather_radius_m` spreads; the tracer has no such limit"


def work_of(run: PovrayRun) -> tuple[object, ...]:
    """What the executions of a run depend on."""
    return (run.photon_sdl, *((each.text, each.width, each.height) for each in run.pictures))


class SharedProgress:
    """Adds the progress of pictures that are drawn together, and ends them together."""

    def __init__(self, progress: Progress, lowered: PovrayScene) -> None:
        self._progress = progress
        works = {work_of(run): run for run in lowered.runs}
        self._total = float(sum(each.width * each.height for run in works.values() for each in run.pictures))
        self._done: dict[str, int] = {}
        self.stop = threading.Event()

    def hear(self, picture: str, line: str, said: list[str]) -> bool:
        """Use every line: progress moves the bar, the rest is kept."""
        found = progress_of(line)
        if found is None:
            said.append(line)
        else:
            self._done[picture] = found[0]
            self._progress(ENGINE, float(sum(self._done.values())), self._total)
        return True


@dataclass(frozen=True)
class Executions:
    """Executes runs; at most as many programs go on at a time as ``slots`` lets in."""

    program: Path
    timeout_s: float
    memory_bytes: int
    shown: SharedProgress
    at_once: int
    slots: threading.Semaphore

    def outcome(self, run: PovrayRun) -> Outcome:
        """Shoot the photons of a run and put their map in order, then draw every picture with them."""
        with scratch("vitrail-povray-") as folder:
            census, photons = None, None
            if run.photon_sdl is not None:
                photons = folder / PHOTON_FILE
                census = self._shot(run, run.photon_sdl, photons)
            # Whoever waits for a slot here holds none.
            with ThreadPoolExecutor(min(self.at_once, len(run.pictures))) as pool:
                try:
                    drawn = pool.map(lambda picture: self._drawn(run, picture, photons), run.pictures)
                    return Outcome(run, tuple(drawn), census)
                except BaseException:
                    pool.shutdown(cancel_futures=True)
                    raise

    def _shot(self, run: PovrayRun, sdl: str, photons: Path) -> PhotonCensus:
        """The census of the photons of a run, whose map it leaves at ``photons``, ordered."""
        with self._folder(run.sky) as folder:
            shot = self._execute(sdl, 1, 1, folder, run.name)
            census = _census(shot, folder / PHOTON_FILE)
            shutil.move(folder / PHOTON_FILE, photons)
        return census

    def _drawn(self, run: PovrayRun, picture: PovrayPicture, photons: Path | None) -> Drawn:
        with self._folder(run.sky) as folder:
            if photons is not None:
                (folder / PHOTON_FILE).hardlink_to(photons)
            done = self._execute(picture.text, picture.width, picture.height, folder, f"{run.name}.{picture.view}")
            image = _image(folder / IMAGE, picture, done.output)
        _check_depth(run, done)
        return Drawn(picture.view, _averaged(image, picture.samples_across, picture.samples_down), done)

    @contextmanager
    def _folder(self, sky: SkyPicture | None) -> Iterator[Path]:
        """A fresh folder with the sky in it, while there is a slot for a program."""
        with self.slots, scratch("vitrail-povray-") as folder:
            if sky is not None:
                _write_sky(folder, sky)
            yield folder

    def _execute(self, sdl: str, width: int, height: int, folder: Path, picture: str) -> Execution:
        """Start POV-Ray once; raises EngineFailure unless it ends well."""
        isolated = picture_command(self.program, sdl, width, height, folder, self.memory_bytes)
        said: list[str] = []
        finished = run_child(
            isolated.command,
            limits=Limits(wall_s=self.timeout_s),
            on_line=lambda line: self.shown.hear(picture, line, said),
            stop=self.shown.stop,
        )
        if finished.interrupted:
            raise KeyboardInterrupt
        output = "\n".join(said)
        _check_ending(finished, output)
        return Execution(finished, output, statistics_of(output), isolated.walls)


def _write_sky(folder: Path, sky: SkyPicture) -> None:
    try:
        write_image(folder / sky.name, sky.pixels, pixel_type="half")
    except ImageError as error:
        remedy = "free room there, or name another folder in TMPDIR"
        raise EngineFailure(ENGINE, f"what it is to see as sky cannot be written ({error})", remedy) from None


def _check_ending(finished: Finished, output: str) -> None:
    if finished.timed_out:
        remedy = "lower the number of photons or samples, or raise the time limit"
        raise EngineFailure(ENGINE, f"it {finished.ending()}", remedy, complaint_of(output))
    if finished.code != 0:
        remedy = TOO_DEEP if finished.code == -signal.SIGSEGV else DEFECT
        raise EngineFailure(ENGINE, f"it {finished.ending()}", remedy, complaint_of(output))


def _census(shot: Execution, path: Path) -> PhotonCensus:
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
        raise EngineFailure(ENGINE, str(error), DEFECT, complaint_of(shot.output)) from None
    return PhotonCensus(shot, len(photons), fluxes_of(photons).sum(axis=0), time.thread_time() - started)


def _image(path: Path, picture: PovrayPicture, output: str) -> np.ndarray:
    """What POV-Ray drew, (height, width, 3); raises EngineFailure when it is missing or not what was asked for."""
    remedy = "check disk space and the limits on file size; its words follow"
    if not path.is_file() or path.stat().st_size == 0:
        raise EngineFailure(ENGINE, "it ended well but wrote no image", remedy, complaint_of(output))
    try:
        image = read_image(path).radiance
    except ImageError as error:
        raise EngineFailure(ENGINE, f"its image cannot be read ({error})", remedy, complaint_of(output)) from None
    if image.shape != (picture.height, picture.width, 3):
        what = f"it wrote {image.shape[1]} x {image.shape[0]} pixels instead of {picture.width} x {picture.height}"
        raise EngineFailure(ENGINE, what, DEFECT, complaint_of(output))
    if lost := int((~np.isfinite(image)).any(axis=2).sum()):
        what = f"{lost} of its {image.shape[0] * image.shape[1]} samples are brighter than its half-float image holds"
        raise EngineFailure(ENGINE, what, TOO_BRIGHT)
    return image


def _averaged(image: np.ndarray, across: int, down: int) -> np.ndarray:
    """The pixels of a picture from its samples."""
    height, width = image.shape[0] // down, image.shape[1] // across
    return image.reshape(height, down, width, across, 3).mean(axis=(1, 3))


def _check_depth(run: PovrayRun, done: Execution) -> None:
    """A path cut short is black without a word [P 4.3]."""
    statistics = done.statistics
    if run.depth_is_proven and statistics.deepest_level >= statistics.level_limit > 0:
        what = f"rays reached the limit of {statistics.level_limit} levels, which the plan proves unreachable"
        raise EngineFailure(ENGINE, what, "this is a defect of the plan; report the scene")
