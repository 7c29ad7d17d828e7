"""Wrong scenes and wrong options: exit code 2, a message that says where and what to do, and no file touched."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from tests.commands.command_line import ROOT, SCENE, files_in, run
from vitrail.commands.app import app, main
from vitrail.commands.errors import exit_codes
from vitrail.engines.povray_result import write_sky

MALFORMED = sorted((ROOT / "tests" / "malformed").glob("*.yaml"))
WRITING_VERBS = {
    "render": lambda scene, out: ("render", scene, "--out", out / "image.exr"),
    "emit tracer": lambda scene, out: ("emit", "tracer", scene, "--out", out),
    "emit povray": lambda scene, out: ("emit", "povray", scene, "--out", out),
}
PRINTING_VERBS = {
    "check": lambda scene: ("check", scene),
    "plan": lambda scene: ("plan", scene),
    "explain": lambda scene: ("explain", scene),
    "trace": lambda scene: ("trace", scene, "--origin", "0,1,0", "--direction", "0,-1,0"),
}


@pytest.mark.parametrize("scene", MALFORMED, ids=lambda path: path.stem)
@pytest.mark.parametrize("verb", WRITING_VERBS)
def test_a_wrong_scene_stops_every_verb_before_it_writes(verb: str, scene: Path, tmp_path: Path) -> None:
    result = run(*WRITING_VERBS[verb](scene, tmp_path))
    assert result.exit_code == 2, result.output
    assert f"{scene}:" in result.stderr
    assert result.stdout == ""
    assert files_in(tmp_path) == []


@pytest.mark.parametrize("verb", PRINTING_VERBS)
def test_a_wrong_scene_is_told_by_every_verb_that_prints(verb: str) -> None:
    scene = MALFORMED[0]
    result = run(*PRINTING_VERBS[verb](scene))
    assert result.exit_code == 2
    assert f"{scene}:" in result.stderr


def test_an_existing_image_survives_a_wrong_scene(tmp_path: Path) -> None:
    image = tmp_path / "image.exr"
    image.write_text("yesterday's work")
    assert run("render", MALFORMED[0], "--out", image).exit_code == 2
    assert image.read_text() == "yesterday's work"
    assert files_in(tmp_path) == ["image.exr"]


def test_a_scene_that_is_not_there_is_a_wrong_scene(tmp_path: Path) -> None:
    result = run("plan", tmp_path / "nothing.yaml")
    assert result.exit_code == 2
    assert "there is no such file" in result.stderr


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--set", "photon=3"), "--set photon=3: is no setting; did you mean `photons`?"),
        (("--set", "photons"), "--set photons: has no value; write key=value"),
        (("--set", "samples=none"), "--set samples=none: is not a whole number; write one from 1 to 1048576"),
        (("--set", "solver=beam"), "--set solver=beam: is not one of auto, photon_map, light_bins, beams;"),
        (("--photons", "-1"), "--photons -1: is below 0; write a whole number from 0 to 1099511627776"),
        (("--quality", "best"), "--quality best: is not one of draft, normal, reference; choose one of them"),
        (
            ("--solver", "beam"),
            "--solver beam: is not one of auto, photon_map, light_bins, beams; did you mean `beams`?",
        ),
        (("--engine", "tracr"), "--engine tracr: is not one of tracer, povray; did you mean `tracer`?"),
        (("--samples", "x"), "--samples x: is not a whole number; write one"),
        (("--threads", "-1"), "--threads -1: is below 0; write 0 or more"),
        (("--budget-s", "soon"), "--budget-s soon: is not a number; write one"),
        (("--solvr", "beams"), "--solvr: there is no such option; did you mean `--solver`?"),
        (("--seed",), "--seed: has no value; write one after it"),
        ((str(SCENE),), "vitrail render: got unexpected extra argument"),
    ],
)
def test_a_wrong_option_is_told_as_it_was_typed(arguments: tuple[str, ...], message: str, tmp_path: Path) -> None:
    """One form whoever finds it: the parser of the command line, its kinds of values, or the settings."""
    result = run("render", SCENE, "--out", tmp_path / "image.exr", *arguments)
    assert result.exit_code == 2
    assert result.stderr.splitlines()[-1].startswith(message), result.stderr
    assert files_in(tmp_path) == []


@pytest.mark.parametrize("verb", ["render", "emit", "compare"])
def test_a_place_that_cannot_be_written_is_told_and_is_no_verdict(verb: str, tmp_path: Path) -> None:
    """A file where a folder must be. Python's own exit code for it would be 1: the scene deviates."""
    taken = tmp_path / "taken"
    taken.write_text("yesterday's work")
    wanted = {"render": ("render", SCENE), "emit": ("emit", "povray", SCENE), "compare": ("compare", SCENE)}[verb]
    result = run(*wanted, "--out", taken / "image.exr" if verb == "render" else taken)
    assert result.exit_code == 2, result.output
    assert f"{taken}: file exists; name another place" in result.stderr
    assert taken.read_text() == "yesterday's work"


def test_a_disk_that_is_full_is_told_and_is_no_defect() -> None:
    with pytest.raises(typer.Exit) as ended, exit_codes(), open("/dev/full", "w", buffering=1) as disk:
        disk.write("more\n")
    assert ended.value.exit_code == 2


def test_an_image_that_cannot_be_written_is_told_and_is_no_defect(tmp_path: Path) -> None:
    with pytest.raises(typer.Exit) as ended, exit_codes():
        write_sky(tmp_path / "sky.exr", np.full((2, 4, 3), 1e6))
    assert ended.value.exit_code == 2


def test_a_defect_of_the_program_is_no_verdict(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken() -> None:
        raise ZeroDivisionError

    monkeypatch.setattr("vitrail.commands.app.app", broken)
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 70


def test_an_image_has_to_be_an_exr(tmp_path: Path) -> None:
    result = run("render", SCENE, "--out", tmp_path / "image.png")
    assert result.exit_code == 2
    assert "end its name with .exr" in result.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--origin", "0,1", "--direction", "0,1,0"), "--origin 0,1: write three numbers"),
        (("--origin", "0,1,0", "--direction", "0,one,0"), "--direction 0,one,0: write three numbers"),
        (("--origin", "0,1,nan", "--direction", "0,1,0"), "write finite numbers"),
        (("--origin", "0,1,0", "--direction", "0,0,0"), "has no direction"),
        (("--origin", "0,1,0", "--direction", "0,1,0", "--band", "1"), "the scene has 1 band(s)"),
        (("--origin", "0,1,0", "--direction", "0,1,0", "--band", "0", "--wavelength-nm", "550"), "give one of them"),
    ],
)
def test_a_wrong_ray_is_told_with_its_remedy(arguments: tuple[str, ...], words: str) -> None:
    result = run("trace", SCENE, *arguments)
    assert result.exit_code == 2
    assert words in result.stderr


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("rendr",), "rendr: there is no such verb; did you mean `render`?\n"),
        (("--versoin",), "--versoin: there is no such option; did you mean `--version`?\n"),
        (("render", "--out", "image.exr"), "SCENE: is missing; `vitrail render --help` says what it takes\n"),
        (
            ("emit", "tracr", "a", "--out", "b"),
            "TARGET tracr: is not one of tracer, povray, views; did you mean `tracer`?\n",
        ),
    ],
)
def test_a_wrong_word_is_told_before_any_verb_runs(arguments: tuple[object, ...], message: str) -> None:
    result = run(*arguments)
    assert (result.exit_code, result.stderr) == (2, message)


def test_the_help_and_the_completion_of_a_shell_know_the_choices() -> None:
    assert "<draft|normal|reference>" in run("render", "--help").stdout
    typed = {"_VITRAIL_COMPLETE": "complete_bash", "COMP_WORDS": "vitrail render --solver ", "COMP_CWORD": "3"}
    completed = CliRunner().invoke(app, prog_name="vitrail", env=typed)
    assert completed.stdout.split() == ["auto", "photon_map", "light_bins", "beams"]


@pytest.mark.parametrize("verb", PRINTING_VERBS)
def test_a_sky_that_is_none_is_a_wrong_scene(verb: str, tmp_path: Path) -> None:
    text = (ROOT / "tests" / "malformed" / "environment_missing.yaml").read_text(encoding="utf-8")
    (tmp_path / "scene.yaml").write_text(text, encoding="utf-8")
    (tmp_path / "sky.exr").write_text("a sky", encoding="utf-8")
    result = run(*PRINTING_VERBS[verb](tmp_path / "scene.yaml"))
    assert result.exit_code == 2
    assert f"{tmp_path}/scene.yaml:12:37: the sky `sky.exr` is not an OpenEXR file" in result.stderr
