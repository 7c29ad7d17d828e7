"""One damaged file through both programs: read in Python, and what was read through the tracer's own reader.

The reader runs in a process of its own, so that a crash, a hang or a hunger for memory is an outcome like another.
"""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import sys
import traceback
from collections import Counter
from collections.abc import Callable, Mapping
from enum import StrEnum
from pathlib import Path
from typing import Any

from tests.fuzz.mutations import mutated
from vitrail.base.canonical_json import canonical_json
from vitrail.base.packed_numbers import pack
from vitrail.engines.tracer import find_tracer
from vitrail.geometry.frame import Frame
from vitrail.geometry.mesh_file import MeshFileError, placed, read_mesh
from vitrail.geometry.mesh_solid import MeshSolid, fault_of_solid
from vitrail.images.exr import ImageError
from vitrail.images.sky import read_sky
from vitrail.scene.model import Mesh

SECONDS = 10
MEMORY_BYTES = 4 << 30
"""Room for addresses; what the libraries reserve without using it counts too."""


class Outcome(StrEnum):
    """What became of a file. The last four are defects."""

    READ = "read by both"
    NO_GLASS = "read by both, refused as glass"
    REFUSED = "refused by name"
    TRACEBACK = "traceback"
    CRASHED = "crashed"
    TOO_LONG = "took too long"
    DISAGREED = "the tracer disagrees"


DEFECTS = (Outcome.TRACEBACK, Outcome.CRASHED, Outcome.TOO_LONG, Outcome.DISAGREED)


def mesh_reader(scene: dict[str, Any]) -> Callable[[Path, Path], Outcome]:
    """Read a mesh as glass; the lowered scene goes into the second file."""

    def read(path: Path, lowered: Path) -> Outcome:
        try:
            found = read_mesh(path)
        except MeshFileError:
            return Outcome.REFUSED
        shape = Mesh(file=path.name)
        fault = fault_of_solid(MeshSolid(placed(found, shape, Frame())))
        normals = {} if found.normals is None else {"normals": pack(found.normals, "f8")}
        frame = {"origin": (0, 0, 0), "rotation": Frame().rotation, "identity": True}
        packed = {"vertices": pack(found.vertices, "f8"), "triangles": pack(found.triangles, "u4"), **normals}
        scene["objects"][1]["shape"] = {"kind": "mesh", **packed, "smooth": True, "frame": frame}
        lowered.write_text(canonical_json(scene))
        return Outcome.READ if fault is None else Outcome.NO_GLASS

    return read


def sky_reader(scene: dict[str, Any]) -> Callable[[Path, Path], Outcome]:
    def read(path: Path, lowered: Path) -> Outcome:
        try:
            sky = read_sky(path)
        except ImageError:
            return Outcome.REFUSED
        height, width, _ = sky.shape
        image = {"width": width, "height": height, "radiance": pack(sky, "f4")}
        scene["lights"] = [{"name": "sky", "kind": "environment", "image": image}]
        lowered.write_text(canonical_json(scene))
        return Outcome.READ

    return read


def run(
    count: int, first_seed: int, good: Mapping[str, bytes], read: Callable[[Path, Path], Outcome], folder: Path
) -> Counter[Outcome]:
    """What became of ``count`` mutations; files that show a defect stay in ``folder``."""
    found: Counter[Outcome] = Counter()
    tracer = find_tracer()
    for seed in range(first_seed, first_seed + count):
        name, content = mutated(seed, dict(good))
        path, lowered = folder / name, folder / "lowered.json"
        path.write_bytes(content)
        outcome = _apart(read, path, lowered, folder / "traceback.txt")
        if outcome in (Outcome.READ, Outcome.NO_GLASS):
            outcome = _held_against(tracer, lowered, outcome)
        found[outcome] += 1
        if outcome in DEFECTS:
            kept = folder / f"defect-{seed}-{name}"
            path.rename(kept)
            print(f"{outcome}: {kept}", file=sys.stderr)
    return found


def _apart(read: Callable[[Path, Path], Outcome], path: Path, lowered: Path, words: Path) -> Outcome:
    """Read in a process of its own with limits."""
    child = os.fork()
    if child == 0:
        signal.setitimer(signal.ITIMER_REAL, SECONDS)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
        try:
            os._exit(list(Outcome).index(read(path, lowered)))
        except BaseException:
            words.write_text(f"{path}\n{traceback.format_exc()}")
            os._exit(list(Outcome).index(Outcome.TRACEBACK))
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return Outcome.TOO_LONG if os.WTERMSIG(status) == signal.SIGALRM else Outcome.CRASHED
    return list(Outcome)[os.WEXITSTATUS(status)]


def _held_against(tracer: Path, lowered: Path, outcome: Outcome) -> Outcome:
    """The tracer takes what was taken for glass here; what was not never reaches it."""
    try:
        code = subprocess.run([tracer, "validate", lowered], capture_output=True, timeout=SECONDS).returncode
    except subprocess.TimeoutExpired:
        return Outcome.TOO_LONG
    if code not in (0, 2):
        return Outcome.CRASHED
    return Outcome.DISAGREED if outcome is Outcome.READ and code else outcome
