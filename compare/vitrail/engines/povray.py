"""POV-Ray as an engine: every run of a lowered scene inside walls, its statistics checked, its pictures added up."""

from __future__ import annotations

import os
import shutil
import threading
import time
from concurrent.futures import Executor, ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

from vitrail.base.progress import Progress, silent
from vitrail.base.scratch import scratch
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.engines.child import Limits, run_child
from vitrail.engines.isolate import Allowance, isolate
from vitrail.engines.povray_output import complaint_of, version_of
from vitrail.engines.povray_result import Outcome, write_result
from vitrail.engines.povray_run import DEFECT, Executions, SharedProgress, work_of
from vitrail.lower.povray import PovrayScene

OLDEST = (3, 7)
TIMEOUT_S = 3600.0
EXTRA_MEMORY_BYTES = 1 << 30
"""Address space beyond the memory limit: the program itself, its libraries and its reserved stacks."""
INSTALL = "install POV-Ray 3.7, on Debian with `apt-get install povray`"


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
        with scratch("vitrail-povray-") as folder:
            isolated = isolate(self.program, ["--version"], folder, Allowance(cpu_s=60))
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

        Views come as povray.<view>.exr. Each execution has one thread, because photons differ with the number of
        threads [P 6]; ``threads`` of them go on at a time (0: one a core). Files appear whole or not at all. Raises
        EngineFailure.
        """
        version, started = self.version(), time.monotonic()
        pictures = sum(len(run.pictures) for run in lowered.runs)
        at_once = min(threads or os.cpu_count() or 1, pictures)
        shown = SharedProgress(progress, lowered)
        memory_bytes = (int(lowered.settings.memory_limit_mb) << 20) + EXTRA_MEMORY_BYTES
        execution = Executions(
            self.program, self._timeout_s, memory_bytes, shown, at_once, threading.Semaphore(at_once)
        )
        with ThreadPoolExecutor(at_once) as pool:
            try:
                outcomes = _outcomes(lowered, execution, pool)
            except BaseException:
                # Let no other run go on for a result that nobody will see.
                shown.stop.set()
                pool.shutdown(cancel_futures=True)
                raise
        self._check_photons(outcomes)
        return write_result(out_dir, lowered, outcomes, version, at_once, time.monotonic() - started)

    def _check_photons(self, outcomes: list[Outcome]) -> None:
        """Photons that lost their light, or their way to the file, are a plausible, wrong picture [P 12.1, 12.2].

        That none arrives anywhere is no fault by itself: their light may leave the scene.
        """
        found = [outcome.census for outcome in outcomes if outcome.census is not None]
        stored = sum(max(census.stored, census.shot.statistics.photons_stored) for census in found)
        if stored and not any(census.flux.any() for census in found):
            what = f"it stored {stored} photons and saved none with light, so the picture would have no caustic"
            raise EngineFailure(self.name, what, DEFECT, complaint_of(found[0].shot.output))


def _outcomes(lowered: PovrayScene, execution: Executions, pool: Executor) -> list[Outcome]:
    """Every run; those with the same texts are executed once, because they would give the same bits."""
    firsts = {work_of(run): run for run in reversed(lowered.runs)}
    found = dict(zip(firsts, pool.map(execution.outcome, firsts.values()), strict=True))
    return [
        found[work_of(run)] if run is firsts[work_of(run)] else replace(found[work_of(run)], run=run, is_repeated=True)
        for run in lowered.runs
    ]
