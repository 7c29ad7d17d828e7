"""Ctrl-C and SIGTERM on the whole program: finished work is kept, the right code comes back, no engine stays behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.commands.command_line import ROOT, SCENE, files_in

pytestmark = pytest.mark.slow

PATIENT_TRACER = f"""#!{sys.executable}
import os, signal, sys, time
value_of = lambda option: sys.argv[sys.argv.index(option) + 1]
def finish(number, frame):
    open(value_of("--out"), "w").write("half an image")
    open(value_of("--record"), "w").write('{{"vitrail_run": 1, "interrupted": true}}')
    sys.exit(130)
signal.signal(signal.SIGINT, finish)
open(os.environ["STARTED"], "w").write(str(os.getpid()))
time.sleep(60)
"""


@pytest.fixture
def under_way(tmp_path: Path):  # type: ignore[no-untyped-def]
    """``vitrail render`` with a tracer that takes a minute: the program, the tracer's number, the output folder."""
    program, started, out = tmp_path / "tracer", tmp_path / "started", tmp_path / "out"
    program.write_text(PATIENT_TRACER, encoding="utf-8")
    program.chmod(0o755)
    environment = {**os.environ, "VITRAIL_TRACER": str(program), "STARTED": str(started)}
    command = [sys.executable, "-m", "vitrail.commands.app", "render", str(SCENE), "--out", str(out / "image.exr")]
    caller = subprocess.Popen(
        command,
        env=environment,
        cwd=ROOT / "compare",
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=with_usual_signals,
    )
    deadline = time.monotonic() + 30
    while not (started.is_file() and started.read_text()):
        assert time.monotonic() < deadline and caller.poll() is None, "the tracer was not started"
        time.sleep(0.02)
    yield caller, int(started.read_text()), out
    caller.kill()
    caller.communicate()


def with_usual_signals() -> None:
    """What runs the tests may ignore signals, as `nohup` does, and the program rightly goes on ignoring those."""
    for order in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
        signal.signal(order, signal.SIG_DFL)


def is_gone(pid: int) -> bool:
    deadline = time.monotonic() + 5
    while time.monotonic() < deadline:
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.02)
    return False


def test_ctrl_c_keeps_the_finished_work_and_ends_with_130(under_way) -> None:  # type: ignore[no-untyped-def]
    caller, tracer, out = under_way
    caller.send_signal(signal.SIGINT)
    _, errors = caller.communicate(timeout=30)
    assert caller.returncode == 130
    assert "the image holds the finished work" in errors
    assert files_in(out) == ["image.exr", "image.run.json"]
    assert (out / "image.exr").read_text() == "half an image"
    assert is_gone(tracer)


@pytest.mark.parametrize(("order", "code"), [(signal.SIGTERM, 143), (signal.SIGHUP, 129), (signal.SIGQUIT, 131)])
def test_an_order_ends_program_and_tracer_and_leaves_nothing(under_way, order: int, code: int) -> None:  # type: ignore[no-untyped-def]
    caller, tracer, out = under_way
    caller.send_signal(order)
    _, errors = caller.communicate(timeout=30)
    assert caller.returncode == code
    assert errors.strip().splitlines()[-1].startswith(f"ended by {signal.Signals(order).name}")
    assert files_in(out) == []
    assert is_gone(tracer)


def test_a_full_disk_ends_with_2_one_line_and_nothing_left(tmp_path: Path) -> None:
    """The tracer says what its library says, and nobody else is blamed."""
    program, out = tmp_path / "tracer", tmp_path / "out"
    words = "vitrail-tracer: a.exr: cannot be written: No space left on device.; choose a folder that can be written"
    program.write_text(f"#!/bin/sh\necho '{words}' >&2\nexit 1\n")
    program.chmod(0o755)
    command = [sys.executable, "-m", "vitrail.commands.app", "render", str(SCENE), "--out", str(out / "image.exr")]
    done = subprocess.run(
        command,
        env={**os.environ, "VITRAIL_TRACER": str(program)},
        cwd=ROOT / "compare",
        capture_output=True,
        text=True,
    )
    assert done.returncode == 2 and files_in(out) == []
    assert done.stderr.splitlines()[-1] == "the disk: no space left on device; name another place, or free this one"


def test_a_killed_program_takes_its_tracer_along_and_the_next_start_sweeps(under_way) -> None:  # type: ignore[no-untyped-def]
    caller, tracer, out = under_way
    caller.kill()
    caller.wait(30)
    assert is_gone(tracer)
    assert files_in(out), "a scratch folder stays behind"
    command = [sys.executable, "-m", "vitrail.commands.app", "render", str(SCENE), "--out", str(out / "image.exr")]
    assert subprocess.run(command, cwd=ROOT / "compare", timeout=120).returncode == 0
    assert files_in(out) == ["image.exr", "image.run.json"]
