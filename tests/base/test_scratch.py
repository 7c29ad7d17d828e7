"""Scratch folders are gone afterwards; those of the dead are gone at the next start, those of the living stay."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from vitrail.base.scratch import scratch, scratch_path, sweep


def made_by(process: int, kind: str, place: Path, suffix: str = "") -> Path:
    """A folder or file with the name that another process would have given it."""
    own = scratch_path(kind, place, suffix)
    path = own.with_name(own.name.replace(f"-{os.getpid()}-", f"-{process}-"))
    if suffix:
        path.write_text("half")
    else:
        path.mkdir()
        (path / "half").write_text("half")
    return path


def a_dead_process() -> int:
    ended = subprocess.Popen(["true"])
    ended.wait()
    return ended.pid


def test_a_folder_is_there_and_then_gone(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError), scratch(".work-", tmp_path) as folder:
        (folder / "file").write_text("x")
        raise ZeroDivisionError
    assert list(tmp_path.iterdir()) == []


def test_what_the_dead_left_is_removed_and_nothing_else(tmp_path: Path) -> None:
    dead, living = a_dead_process(), os.getppid()
    left = [made_by(dead, ".work-", tmp_path), made_by(dead, ".partial-", tmp_path, ".exr")]
    kept = [made_by(living, ".work-", tmp_path), made_by(dead, ".other-", tmp_path)]
    (tmp_path / ".work-of-mine").mkdir()
    (tmp_path / ".work-0123abcd-1-0123abcd").mkdir()  # of another machine
    for kind in (".work-", ".partial-"):
        sweep.__wrapped__(kind, tmp_path)
    assert not any(each.exists() for each in left)
    assert all(each.exists() for each in kept) and len(list(tmp_path.iterdir())) == 4
