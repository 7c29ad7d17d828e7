"""Which build of an engine made a sample: its version, and the fingerprint of the program itself."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path
from typing import Literal

from vitrail.engines.povray import Povray
from vitrail.engines.tracer import Tracer


def engine_build(engine: Literal["tracer", "povray"]) -> str:
    """Such as ``vitrail-tracer 0.1.0 (3f2a9c81d0e4)``: while it is being worked on, the version says too little."""
    found: Tracer | Povray = Tracer() if engine == "tracer" else Povray()
    return f"{found.version()} ({_fingerprint(Path(found.program))})"


def _fingerprint(program: Path) -> str:
    """The first digits of the SHA-256 of the program's file."""
    changed = program.stat()
    return _fingerprint_of(program, changed.st_mtime_ns, changed.st_size)


@cache
def _fingerprint_of(program: Path, changed_ns: int, size: int) -> str:
    return hashlib.sha256(program.read_bytes()).hexdigest()[:12]
