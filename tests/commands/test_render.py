"""``vitrail render`` with a tracer that is there, missing, or interrupted."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.commands.command_line import SCENE, fake_tracer, files_in, run

pytestmark = pytest.mark.tracer


@pytest.fixture
def out(tmp_path: Path) -> Path:
    folder = tmp_path / "out"
    folder.mkdir()
    return folder


def test_image_and_record_come_home(out: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("VITRAIL_TRACER", str(fake_tracer(tmp_path)))
    result = run("render", SCENE, "--out", out / "new" / "image.exr", "--quality", "draft")
    assert result.exit_code == 0, result.stderr
    assert files_in(out) == ["new", "new/image.exr", "new/image.run.json"]
    assert (out / "new" / "image.exr").read_text() == "image"
    assert json.loads((out / "new" / "image.run.json").read_text())["vitrail_run"] == 1


def test_the_record_is_printed_as_json(out: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("VITRAIL_TRACER", str(fake_tracer(tmp_path)))
    result = run("render", SCENE, "--out", out / "image.exr", "--json")
    assert json.loads(result.stdout)["vitrail_run"] == 1


def test_an_interrupted_run_keeps_what_was_done_and_ends_with_130(
    out: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("VITRAIL_TRACER", str(fake_tracer(tmp_path, interrupted=True)))
    result = run("render", SCENE, "--out", out / "image.exr")
    assert result.exit_code == 130
    assert "the image holds the finished work" in result.stderr
    assert files_in(out) == ["image.exr", "image.run.json"]


@pytest.mark.parametrize("verb", ["render", "trace"])
def test_a_missing_tracer_ends_with_4_and_the_remedy(
    verb: str, out: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.delenv("VITRAIL_TRACER", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("vitrail.__file__", str(tmp_path / "a" / "vitrail" / "__init__.py"))
    more = ("--out", out / "image.exr") if verb == "render" else ("--origin", "0,1,0", "--direction", "0,-1,0")
    result = run(verb, SCENE, *more)
    assert result.exit_code == 4
    assert "the program vitrail-tracer is not built; run `make build`, or set VITRAIL_TRACER" in result.stderr
    assert files_in(out) == []


def test_a_crashing_tracer_ends_with_4_and_leaves_no_image(
    out: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    program = tmp_path / "crash"
    program.write_text("#!/bin/sh\necho 'out of photons' >&2\nkill -SEGV $$\n")
    program.chmod(0o755)
    monkeypatch.setenv("VITRAIL_TRACER", str(program))
    (out / "image.exr").write_text("yesterday's work")
    result = run("render", SCENE, "--out", out / "image.exr")
    assert result.exit_code == 4
    assert "SIGSEGV" in result.stderr
    assert "tracer: out of photons" in result.stderr
    assert files_in(out) == ["image.exr"]
    assert (out / "image.exr").read_text() == "yesterday's work"
