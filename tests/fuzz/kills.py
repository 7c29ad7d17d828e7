"""``vitrail render`` killed at a random moment, and started again: the same bytes, and nothing left behind."""

from __future__ import annotations

import hashlib
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENE = Path(__file__).parents[1] / "golden" / "plain.yaml"


def kill_often(count: int, seed: int, folder: Path) -> list[str]:
    """What was wrong after ``count`` kills: other bytes, or a file too many. Empty when all is well."""
    chance, whole = random.Random(seed), folder / "whole"
    started = time.monotonic()
    _start(whole).wait(120)
    usual_s, expected = time.monotonic() - started, _bytes_of(whole / "image.exr")
    wrong = [] if files_in(whole) == ["image.exr", "image.run.json"] else [f"undisturbed: {files_in(whole)}"]
    for kill in range(count):
        out = folder / f"{kill}"
        victim = _start(out)
        time.sleep(chance.uniform(0.2, 1.0) * usual_s)
        victim.kill()
        victim.wait(30)
        half = [name for name in files_in(out) if name == "image.exr" and _bytes_of(out / name) != expected]
        if _start(out).wait(120) != 0 or half or _bytes_of(out / "image.exr") != expected:
            wrong.append(f"kill {kill}: other bytes {half}")
        if files_in(out) != ["image.exr", "image.run.json"]:
            wrong.append(f"kill {kill}: {files_in(out)}")
    return wrong


def files_in(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.glob("*")) if folder.is_dir() else []


def _start(out: Path) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "vitrail.commands.app", "render", str(SCENE), "--out", str(out / "image.exr")]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    return subprocess.Popen([*command, "--threads", "1"], env={**os.environ, "TMPDIR": tempfile.gettempdir()}, **quiet)


def _bytes_of(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() else "none"
