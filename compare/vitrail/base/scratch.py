"""Folders and files that are gone when the work is done: and where the work was killed, when the next one starts.

A name says who makes it: the space of process numbers, and the number. What nobody alive makes any more is removed by
whoever makes something of the same kind in the same place.
"""

from __future__ import annotations

import hashlib
import os
import re
import secrets
import shutil
import socket
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

_MADE_BY = re.compile(r"(?P<space>[0-9a-f]{8})-(?P<process>\d+)-[0-9a-f]{8}(?P<rest>\..*)?")


@contextmanager
def scratch(kind: str, place: Path | None = None) -> Iterator[Path]:
    """A new folder in ``place`` (where temporary files are, if not given), removed afterwards."""
    folder = scratch_folder(kind, place or Path(tempfile.gettempdir()))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def scratch_folder(kind: str, place: Path) -> Path:
    """A new folder for somebody who removes it, or moves it to where it stays."""
    folder = scratch_path(kind, place)
    folder.mkdir(mode=0o700, parents=True)
    return folder


def scratch_path(kind: str, place: Path, suffix: str = "") -> Path:
    """A name in ``place`` that nobody else takes. What the dead left there of the same kind is removed first."""
    sweep(kind, place)
    return place / f"{kind}{_space()}-{os.getpid()}-{secrets.token_hex(4)}{suffix}"


@cache
def sweep(kind: str, place: Path) -> None:
    """Remove what programs that were killed have left; once for a place, as each program is new to it only once."""
    try:
        left = [each for each in place.iterdir() if each.name.startswith(kind) and _is_of_the_dead(each.name, kind)]
    except OSError:
        return
    for each in left:
        if each.is_dir() and not each.is_symlink():
            shutil.rmtree(each, ignore_errors=True)
        else:
            each.unlink(missing_ok=True)


def _is_of_the_dead(name: str, kind: str) -> bool:
    made = _MADE_BY.fullmatch(name[len(kind) :])
    if made is None or made["space"] != _space():
        return False
    try:
        os.kill(int(made["process"]), 0)
    except ProcessLookupError:
        return True
    except OSError:
        return False
    return False


@cache
def _space() -> str:
    """Where a process number means one process: this machine, or this container on it."""
    try:
        numbers = os.readlink("/proc/self/ns/pid")
    except OSError:
        numbers = ""
    return hashlib.sha256(f"{socket.gethostname()} {numbers}".encode()).hexdigest()[:8]
