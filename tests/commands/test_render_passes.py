"""``vitrail render`` by passes: its stops and exit codes, and Ctrl-C on the whole program with the real tracer."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.commands.command_line import ROOT, files_in, run
from vitrail.images.exr import read_image

pytestmark = [pytest.mark.tracer, pytest.mark.slow]

BALL = ROOT / "scenes" / "calibration" / "ball_lens.yaml"
CHEAP = ("--set", "photons=2000", "--set", "samples=2", "--threads", "1")

STUBBORN_TRACER = f"""#!{sys.executable}
import os, signal, sys, time
if sys.argv[1] == "version":
    print("vitrail-tracer 1")
    sys.exit()
signal.signal(signal.SIGINT, lambda number, frame: sys.exit(130))
open(os.environ["STARTED"], "w").write(str(os.getpid()))
time.sleep(60)
"""


def passes_in(out: Path) -> dict:  # type: ignore[type-arg]
    return json.loads(out.with_suffix(".run.json").read_text())["passes"]  # type: ignore[no-any-return]


def test_passes_leave_image_record_and_checkpoint(tmp_path: Path) -> None:
    out = tmp_path / "new" / "image.exr"
    result = run("render", BALL, "--out", out, *CHEAP, "--passes", "2", "--json")
    assert result.exit_code == 0, result.stderr
    assert files_in(out.parent) == ["image.exr", "image.passes.npz", "image.run.json"]
    found = json.loads(result.stdout)["passes"]
    assert (found["count"], found["stopped_by"], len(found["gather_radius_m"])) == (2, "passes", 2)
    assert found == passes_in(out)
    assert json.loads(str(read_image(out).metadata["vitrail:passes"]))["count"] == 2


def test_a_target_that_the_budget_does_not_reach_ends_with_5_and_says_how_to_go_on(tmp_path: Path) -> None:
    aims = ("--target-error", "caustic=0.0001", "--budget-s", "0.01")
    result = run("render", BALL, "--out", tmp_path / "image.exr", *CHEAP, *aims)
    assert result.exit_code == 5
    assert "wanted 0.0001; about" in result.stderr and "passes more" in result.stderr
    assert "--resume" in result.stderr
    assert "the pixels of this image blur caustic (annulus_mean.0)" in result.stderr


def test_an_error_that_is_large_enough_is_met_by_one_pass(tmp_path: Path) -> None:
    aim = ("--target-error", "caustic.caustic_flux=0.5")
    result = run("render", BALL, "--out", tmp_path / "image.exr", *CHEAP, *aim)
    assert result.exit_code == 0, result.stderr
    assert passes_in(tmp_path / "image.exr")["stopped_by"] == "target_error"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (
            ("--target-error", "shadow=0.1"),
            "the scene observes caustic; name one of them, or add an entry to `observe`",
        ),
        (("--target-error", "caustic=2"), "write a share above 0 and below 1, such as caustic=0.01"),
        (("--resume",), "say when to stop; add --passes, --budget-s or --target-error"),
        (("--resume", "--passes", "2"), "image.passes.npz: there is no checkpoint to resume"),
        (("--passes", "2", "--samples", "1"), "ask for 2 samples or more"),
        (("--passes", "2", "--engine", "povray"), "only the tracer renders by passes"),
    ],
)
def test_wrong_use_is_refused_with_the_remedy(arguments: tuple[str, ...], words: str, tmp_path: Path) -> None:
    result = run("render", BALL, "--out", tmp_path / "image.exr", *arguments)
    assert result.exit_code == 2, result.output
    assert words in result.stderr
    assert files_in(tmp_path) == []


@contextlib.contextmanager
def under_way(out: Path, *arguments: str, **environment: str) -> Iterator[subprocess.Popen[str]]:
    """The program in a process of its own; it is gone afterwards."""
    options = ("--threads", "1", "--out", str(out), *arguments)
    command = [sys.executable, "-m", "vitrail.commands.app", "render", str(BALL), *options]
    caller = subprocess.Popen(
        command,
        env={**os.environ, **environment},
        cwd=ROOT / "compare",
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        yield caller
    finally:
        caller.kill()
        caller.communicate()


def wait_for(file: Path, caller: subprocess.Popen[str]) -> None:
    deadline = time.monotonic() + 30
    while not (file.is_file() and file.stat().st_size):
        assert time.monotonic() < deadline and caller.poll() is None, caller.communicate()
        time.sleep(0.01)


def test_ctrl_c_finishes_the_pass_and_another_sitting_ends_as_one_would(tmp_path: Path) -> None:
    out = tmp_path / "image.exr"
    with under_way(out, "--passes", "1000", "--set", "photons=2000", "--set", "samples=2") as caller:
        wait_for(tmp_path / "image.passes.npz", caller)
        caller.send_signal(signal.SIGINT)
        _, errors = caller.communicate(timeout=30)
    assert caller.returncode == 130, errors
    assert "finishing the pass at hand" in errors and "to go on: vitrail render" in errors
    assert files_in(tmp_path) == ["image.exr", "image.passes.npz", "image.run.json"]
    found = passes_in(out)
    assert 1 <= found["count"] < 1000 and found["stopped_by"] == "interrupted"
    more = str(found["count"] + 1)
    assert run("render", BALL, "--out", out, *CHEAP, "--passes", more, "--resume").exit_code == 0
    assert run("render", BALL, "--out", tmp_path / "one.exr", *CHEAP, "--passes", more).exit_code == 0
    np.testing.assert_array_equal(read_image(out).radiance, read_image(tmp_path / "one.exr").radiance)


def test_a_second_ctrl_c_abandons_the_pass(tmp_path: Path) -> None:
    program, started = tmp_path / "tracer", tmp_path / "started"
    program.write_text(STUBBORN_TRACER, encoding="utf-8")
    program.chmod(0o755)
    out = tmp_path / "out" / "image.exr"
    with under_way(out, "--passes", "2", VITRAIL_TRACER=str(program), STARTED=str(started)) as caller:
        wait_for(started, caller)
        caller.send_signal(signal.SIGINT)
        assert caller.stderr is not None
        assert (
            caller.stderr.readline() + caller.stderr.readline()
            == "\nfinishing the pass at hand; Ctrl-C again abandons it\n"
        )
        assert caller.poll() is None
        caller.send_signal(signal.SIGINT)
        _, errors = caller.communicate(timeout=30)
    assert caller.returncode == 130
    assert "interrupted before the first pass was done; nothing was written" in errors
    assert files_in(out.parent) == []
    with pytest.raises(ProcessLookupError):
        os.kill(int(started.read_text()), 0)
