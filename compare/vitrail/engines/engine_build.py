"""Which build of an engine made a sample: its version, and the fingerprint of the program itself."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path

from vitrail.base.engine_name import EngineName
from vitrail.engines.base import Engine
from vitrail.engines.installed import engine_named


def engine_build(engine: EngineName) -> str:
    """The build of the installed engine, such as ``vitrail-tracer 0.1.0 (3f2a9c81d0e4)``."""
    return build_of(engine_named(engine))


def build_of(engine: Engine) -> str:
    """An engine's version and fingerprint: while a program is being worked on, the version says too little.

    An engine that is no program of its own is known by its version alone.
    """
    program = getattr(engine, "program", None)
    return engine.version() if program is None else f"{engine.version()} ({_fingerprint(Path(program))})"


def _fingerprint(program: Path) -> str:
    """The first digits of the SHA-256 of the program's file."""
    changed = program.stat()
    return _fingerprint_of(program, changed.st_mtime_ns, changed.st_size)


@cache
def _fingerprint_of(program: Path, changed_ns: int, size: int) -> str:
    return hashlib.sha256(program.read_bytes()).hexdigest()[:12]
