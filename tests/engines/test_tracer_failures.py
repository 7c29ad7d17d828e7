"""A tracer that is missing, refuses, crashes, or writes nothing: said in its own words, and no image is left."""

from __future__ import annotations

import json
import stat
import sys
from pathlib import Path
from typing import Any

import pytest

from vitrail.engines.base import EngineFailure
from vitrail.engines.tracer import Tracer, find_tracer

LOWERED: dict[str, Any] = {"vitrail_lowered": 1, "settings": {"memory_limit_mb": 512}}

WRITES = """
value_of = lambda option: sys.argv[sys.argv.index(option) + 1]
open(value_of("--out"), "w").write("image")
open(value_of("--record"), "w").write('{"vitrail_run": 1, "interrupted": false}')
"""


VIEWED: dict[str, Any] = {**LOWERED, "views": [{"name": "spot"}, {"name": "rim"}]}

WRITES_VIEWS = """
for name in ("spot", "rim"):
    open(os.path.join(value_of("--views"), name + ".exr"), "w").write(name)
"""


def fake(tmp_path: Path, code: str) -> Tracer:
    """A tracer that is a few lines of Python."""
    program = tmp_path / "fake-tracer"
    program.write_text(f"#!{sys.executable}\nimport sys, os, time, signal\n{code}\n", encoding="utf-8")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    return Tracer(program)


def failure(tmp_path: Path, code: str) -> EngineFailure:
    out = tmp_path / "out"
    with pytest.raises(EngineFailure) as raised:
        fake(tmp_path, code).render(LOWERED, out)
    assert list(out.iterdir()) == []
    return raised.value


def test_a_good_run_brings_image_record_and_input_home(tmp_path: Path) -> None:
    steps: list[tuple[str, float, float]] = []
    progress = """sys.stderr.write('{"phase": "camera", "done": 3, "total": 4}\\n')"""
    made = fake(tmp_path, progress + WRITES).render(
        LOWERED, tmp_path / "out", progress=lambda phase, done, total: steps.append((phase, done, total))
    )
    assert steps == [("camera", 3.0, 4.0)]
    assert made.image_path.read_text() == "image"
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [
        "tracer.exr",
        "tracer.json",
        "tracer.run.json",
    ]
    assert made.record["process"]["cpu_s"] > 0
    assert json.loads((tmp_path / "out" / "tracer.run.json").read_text()) == made.record
    assert not made.interrupted


def test_the_pictures_of_views_come_home_by_name(tmp_path: Path) -> None:
    out = tmp_path / "out"
    made = fake(tmp_path, WRITES + WRITES_VIEWS).render(VIEWED, out)
    assert made.views == {"spot": out / "tracer.spot.exr", "rim": out / "tracer.rim.exr"}
    assert {path.read_text() for path in made.views.values()} == {"spot", "rim"}
    assert sorted(path.name for path in out.iterdir()) == [
        "tracer.exr",
        "tracer.json",
        "tracer.rim.exr",
        "tracer.run.json",
        "tracer.spot.exr",
    ]
    assert fake(tmp_path, WRITES).render(LOWERED, tmp_path / "plain").views == {}


def test_a_run_without_one_of_its_views_is_a_failure(tmp_path: Path) -> None:
    code = WRITES + WRITES_VIEWS + "os.remove(os.path.join(value_of('--views'), 'rim.exr'))"
    with pytest.raises(EngineFailure, match=r"wrote no image rim\.exr"):
        fake(tmp_path, code).render(VIEWED, tmp_path / "out")
    assert list((tmp_path / "out").iterdir()) == []


def test_threads_are_passed_on_only_when_chosen(tmp_path: Path) -> None:
    code = WRITES + "open(value_of('--record'), 'w').write('{\"heard\": \"%s\"}' % ' '.join(sys.argv[1:]))"
    tracer = fake(tmp_path, code)
    assert "--threads 3" in tracer.render(LOWERED, tmp_path / "out", threads=3).record["heard"]
    assert "--threads" not in tracer.render(LOWERED, tmp_path / "out").record["heard"]


def test_a_refusal_quotes_the_tracer(tmp_path: Path) -> None:
    found = failure(tmp_path, "sys.stderr.write('camera.position: is not a vector; write three numbers'); sys.exit(2)")
    assert "refused its input" in str(found)
    assert "tracer: camera.position: is not a vector; write three numbers" in str(found)


def test_a_crash_names_the_signal_and_quotes_the_last_words(tmp_path: Path) -> None:
    found = failure(tmp_path, "sys.stderr.write('about to fall'); sys.stderr.flush(); os.kill(os.getpid(), 11)")
    assert "was ended by SIGSEGV" in str(found)
    assert "about to fall" in str(found)


def test_a_run_without_an_image_is_a_failure(tmp_path: Path) -> None:
    assert "wrote no image" in str(failure(tmp_path, "pass"))


def test_a_run_without_a_record_is_a_failure(tmp_path: Path) -> None:
    found = failure(tmp_path, "open(sys.argv[sys.argv.index('--out') + 1], 'w').write('image')")
    assert "wrote no run record" in str(found)


def test_a_broken_record_is_a_failure(tmp_path: Path) -> None:
    code = "for key in ('--out', '--record'): open(sys.argv[sys.argv.index(key) + 1], 'w').write('{')"
    assert "its run record is not JSON" in str(failure(tmp_path, code))


def test_a_program_that_cannot_start_is_a_failure(tmp_path: Path) -> None:
    program = tmp_path / "fake-tracer"
    program.write_bytes(b"\x00\x01")
    program.chmod(0o755)
    with pytest.raises(EngineFailure, match="cannot be started"):
        Tracer(program).version()


def test_a_named_tracer_that_is_none_is_a_failure(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("VITRAIL_TRACER", str(tmp_path / "nothing"))
    with pytest.raises(EngineFailure, match="VITRAIL_TRACER names .*nothing"):
        find_tracer()


def test_no_tracer_anywhere_says_how_to_get_one(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("VITRAIL_TRACER", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("vitrail.__file__", str(tmp_path / "a" / "vitrail" / "__init__.py"))
    with pytest.raises(EngineFailure, match="not built; run `make build`, or set VITRAIL_TRACER"):
        find_tracer()


def test_an_installed_tracer_lies_in_the_package(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    program = tmp_path / "vitrail" / "bin" / "vitrail-tracer"
    program.parent.mkdir(parents=True)
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    monkeypatch.delenv("VITRAIL_TRACER", raising=False)
    monkeypatch.setattr("vitrail.__file__", str(tmp_path / "vitrail" / "__init__.py"))
    assert find_tracer() == program


def test_a_rendering_that_takes_too_long_is_ended_and_says_so(tmp_path: Path) -> None:
    program = fake(tmp_path, "time.sleep(60)").program
    with pytest.raises(EngineFailure, match="it was stopped after 1 s"):
        Tracer(program, timeout_s=0.7).render(LOWERED, tmp_path / "out")


def test_a_ray_that_ctrl_c_stopped_is_no_broken_answer(tmp_path: Path) -> None:
    # The program presses Ctrl-C for us, and ends as the tracer does when it is passed on.
    code = "signal.signal(2, lambda *rest: sys.exit(130)); os.kill(os.getppid(), 2); time.sleep(10)"
    with pytest.raises(KeyboardInterrupt):
        fake(tmp_path, code).trace(LOWERED, [])
