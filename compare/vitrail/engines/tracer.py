"""Our own tracer as an engine: found, run on the lowered scene, its image and run record brought home."""

from __future__ import annotations

import errno
import json
import os
import shutil
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import vitrail
from vitrail.base.canonical_json import canonical_json
from vitrail.base.disk_error import is_full
from vitrail.base.exit_code import ExitCode
from vitrail.base.progress import Progress, silent
from vitrail.base.scratch import scratch
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.engines.child import GIBIBYTE, Finished, Limits, run_child

PROGRAM = "vitrail-tracer"

REBUILD = "build it again with `make build`"

NOT_STARTED = (126, 127)
"""How what goes before the tracer ends where there is nothing that can be executed."""

ADDRESS_ROOM_BYTES = 8 * GIBIBYTE
"""Address space beyond the tracer's memory limit: thread stacks and allocator arenas reserve it without using it."""


def find_tracer() -> Path:
    """The tracer's program: ``VITRAIL_TRACER``, the installed package, a build in the source tree, or the path.

    Raises EngineFailure with what to do.
    """
    named = os.environ.get("VITRAIL_TRACER")
    if named:
        if os.access(named, os.X_OK) and Path(named).is_file():
            return Path(named)
        raise EngineFailure("tracer", f"VITRAIL_TRACER names {named}, which is no program", "unset it or correct it")
    package = Path(vitrail.__file__).parent
    builds = [package.parents[1] / "build" / preset / "tracer" for preset in ("release", "dev")]
    for folder in (package / "bin", *builds):
        if os.access(folder / PROGRAM, os.X_OK):
            return folder / PROGRAM
    on_path = shutil.which(PROGRAM)
    if on_path is not None:
        return Path(on_path)
    raise EngineFailure("tracer", f"the program {PROGRAM} is not built", "run `make build`, or set VITRAIL_TRACER")


class Tracer:
    """The tracer as an engine. ``timeout_s`` is for one rendering; None lets it take as long as it needs."""

    name = "tracer"

    def __init__(self, program: Path | None = None, timeout_s: float | None = None) -> None:
        self._program, self._timeout_s = program, timeout_s

    @property
    def program(self) -> Path:
        """Where the tracer is; raises EngineFailure when it is nowhere."""
        if self._program is None:
            self._program = find_tracer()
        return self._program

    def version(self) -> str:
        """The tracer's own version line."""
        return self._run(["version"], Limits(wall_s=30)).stdout.strip()

    def render(
        self, lowered: dict[str, Any], out_dir: Path, *, threads: int = 0, progress: Progress = silent
    ) -> Rendering:
        """Render ``lowered`` into ``out_dir``: tracer.json (the input), tracer.exr, tracer.run.json.

        Each view of ``lowered`` becomes tracer.<view>.exr.

        ``threads`` 0 takes every core. Files appear whole or not at all; after Ctrl-C they hold the finished work and
        the record says so. Raises EngineFailure, and KeyboardInterrupt when nothing was finished.
        """
        out_dir.mkdir(parents=True, exist_ok=True)
        with scratch(".tracer-", out_dir) as work:
            scene, image, record = (work / f"tracer.{kind}" for kind in ("json", "exr", "run.json"))
            scene.write_text(canonical_json(lowered), encoding="utf-8")
            views = {view["name"]: work / "views" / f"{view['name']}.exr" for view in lowered.get("views", ())}
            options = ["--out", str(image), "--record", str(record), "--progress", *_views_option(work, views)]
            options += ["--threads", str(threads)] if threads else []
            limits = Limits(memory_bytes=_address_space(lowered), wall_s=self._timeout_s)
            finished = self._run(["render", str(scene), *options], limits, progress)
            if finished.interrupted and not (image.is_file() and record.is_file()):
                raise KeyboardInterrupt
            found = _read_record(finished, (image, *views.values()), record)
            homes = {name: out_dir / f"tracer.{name}.exr" for name in views}
            for name, file in views.items():
                os.replace(file, homes[name])
            for file in (scene, record, image):
                os.replace(file, out_dir / file.name)
        return Rendering(out_dir / image.name, found, homes)

    def trace(self, lowered: dict[str, Any], arguments: Sequence[str]) -> dict[str, Any]:
        """Follow one ray; the answer is the tracer's own, with its vertices. Raises EngineFailure."""
        with scratch("vitrail-trace-") as work:
            scene = work / "scene.json"
            scene.write_text(canonical_json(lowered), encoding="utf-8")
            finished = self._run(["trace", str(scene), *arguments], Limits(wall_s=600))
        if finished.interrupted:
            raise KeyboardInterrupt
        return _read_json(finished, finished.stdout, "its answer")

    def _run(self, arguments: Sequence[str], limits: Limits, progress: Progress = silent) -> Finished:
        """Run the program; raises EngineFailure unless it ended well or was interrupted."""
        try:
            finished = run_child(
                [*_dies_with_us(), self.program, *arguments], limits=limits, on_line=_listener(progress)
            )
        except OSError as error:
            raise EngineFailure(self.name, f"{self.program} cannot be started ({error.strerror})", REBUILD) from None
        if finished.code == 0 or finished.interrupted:
            return finished
        if is_full(finished.said):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        if finished.code in NOT_STARTED:
            raise EngineFailure(self.name, f"{self.program} cannot be started", REBUILD, finished.said)
        if finished.code == ExitCode.SCENE_ERROR:
            remedy = "this is a defect of the lowering or a limit of the tracer; its words follow"
            raise EngineFailure(self.name, "it refused its input", remedy, finished.said)
        remedy = "run it again with fewer photons or threads if memory ran out; its words follow"
        raise EngineFailure(self.name, f"it {finished.ending()}", remedy, finished.said)


@cache
def _dies_with_us() -> tuple[str, ...]:
    """What goes before the program, so that it does not go on where we are killed."""
    return ("setpriv", "--pdeathsig=KILL") if shutil.which("setpriv") else ()


def _address_space(lowered: dict[str, Any]) -> int:
    return int(lowered["settings"]["memory_limit_mb"]) * 2**20 + ADDRESS_ROOM_BYTES


def _views_option(work: Path, views: dict[str, Path]) -> list[str]:
    """Where the tracer puts the pictures of views, a folder made for them; nothing where there are none."""
    if not views:
        return []
    folder = work / "views"
    folder.mkdir()
    return ["--views", str(folder)]


def _listener(progress: Progress) -> Any:
    """Use up the lines that are progress, and leave the words."""

    def use(line: str) -> bool:
        try:
            step = json.loads(line)
            progress(str(step["phase"]), float(step["done"]), float(step["total"]))
        except (ValueError, KeyError, TypeError):
            return False
        return True

    return use


def _read_record(finished: Finished, images: Sequence[Path], record: Path) -> dict[str, Any]:
    """The run record, with what we measured from outside; raises EngineFailure when a file of the run is missing."""
    for file, what in (*((image, f"no image {image.name}") for image in images), (record, "no run record")):
        if not file.is_file() or file.stat().st_size == 0:
            raise EngineFailure("tracer", f"it ended well but wrote {what}", "build it again", finished.said)
    found = _read_json(finished, record.read_text(encoding="utf-8"), "its run record")
    found["process"] = {
        "cpu_s": finished.cpu_s,
        "wall_s": finished.wall_s,
        "peak_memory_bytes": finished.peak_memory_bytes,
    }
    record.write_text(canonical_json(found), encoding="utf-8")
    return found


def _read_json(finished: Finished, text: str, what: str) -> dict[str, Any]:
    try:
        found = json.loads(text)
    except ValueError as error:
        said = "\n".join((finished.said, text[:500]))
        raise EngineFailure("tracer", f"{what} is not JSON ({error})", "build it again", said) from None
    assert isinstance(found, dict)
    return found
