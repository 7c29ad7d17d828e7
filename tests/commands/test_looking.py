"""The verbs that look at a scene and write nothing: check, plan, explain, emit, and the help."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.commands.command_line import ROOT, SCENE, files_in, run
from vitrail.base.phenomenon import Phenomenon
from vitrail.commands.app import VERBS, Verbs
from vitrail.images.exr import write_image

pytestmark = pytest.mark.slow

ALL_SCENES = sorted((ROOT / "scenes").glob("*/*.yaml"))


def test_the_help_names_every_verb_that_exists_and_loads_none() -> None:
    code = (
        "import sys; from typer.testing import CliRunner; from vitrail.commands.app import app\n"
        "print(CliRunner().invoke(app, ['--help']).output)\n"
        "print('loaded', sorted(n for n in sys.modules if n.startswith('vitrail.') or n in ('numpy', 'pydantic')))"
    )
    answer = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT / "compare"
    )
    assert "loaded ['vitrail.commands', 'vitrail.commands.app']" in answer.stdout
    assert all(verb in answer.stdout for verb in Verbs())


def test_every_verb_loads_and_has_its_own_help() -> None:
    for verb in Verbs():
        result = run(verb, "--help")
        assert result.exit_code == 0, result.output
    assert set(Verbs()) <= set(VERBS)


def test_check_says_that_a_scene_is_good() -> None:
    result = run("check", SCENE)
    assert result.exit_code == 0
    assert "good (objects: 2, lights: 1)" in result.stdout


def test_check_reports_all_files_and_fails_if_one_is_wrong() -> None:
    wrong = sorted((ROOT / "tests" / "malformed").glob("*.yaml"))[0]
    result = run("check", SCENE, wrong, "--json")
    assert result.exit_code == 2
    good, bad = json.loads(result.stdout)
    assert good["errors"] == []
    assert bad["errors"][0]["line"] >= 1
    assert bad["errors"][0]["message"].startswith(f"{wrong}:")


@pytest.mark.parametrize("scene", ALL_SCENES, ids=lambda path: path.stem)
def test_every_scene_of_the_project_has_a_plan(scene: Path) -> None:
    result = run("plan", scene, "--json")
    assert result.exit_code == 0, result.stderr
    plan = json.loads(result.stdout)
    assert list(plan["phenomena"]) == [phenomenon.value for phenomenon in Phenomenon]
    assert plan["settings"]["gather_radius_m"] > 0


def test_the_plan_for_people_has_evidence_cost_and_what_is_spared() -> None:
    words = run("plan", SCENE).stdout
    for part in (
        "caustic",
        "`sun` -> `ball` (at most 28.3 W)",
        "one photon pass",
        "not required",
        "longest chain: 0 refl",
    ):
        assert part in words


def test_emit_tracer_writes_the_golden_text(tmp_path: Path) -> None:
    result = run("emit", "tracer", SCENE, "--out", tmp_path, "--json")
    assert result.exit_code == 0
    assert files_in(tmp_path) == ["scene.json"]
    assert json.loads(result.stdout) == {"files": [str(tmp_path / "scene.json")]}
    assert (tmp_path / "scene.json").read_text() == (ROOT / "tests" / "golden" / "plain.json").read_text()


def test_emit_obeys_settings(tmp_path: Path) -> None:
    assert run("emit", "tracer", SCENE, "--out", tmp_path, "--quality", "draft", "--set", "seed=7").exit_code == 0
    settings = json.loads((tmp_path / "scene.json").read_text())["settings"]
    assert (settings["samples"], settings["photons"], settings["seed"]) == (1, 100_000, 7)


def test_emit_povray_writes_scene_texts_and_the_certificate(tmp_path: Path) -> None:
    result = run("emit", "povray", SCENE, "--out", tmp_path)
    assert result.exit_code == 0, result.stderr
    names = files_in(tmp_path)
    assert "certificate.json" in names
    assert any(name.endswith(".pov") for name in names)


def test_emit_povray_readable_writes_one_scene_file_and_what_it_approximates(tmp_path: Path) -> None:
    result = run("emit", "povray", SCENE, "--readable", "--out", tmp_path)
    assert result.exit_code == 0, result.stderr
    assert sum(name.endswith(".pov") for name in files_in(tmp_path)) == 1
    assert json.loads((tmp_path / "certificate.json").read_text())


def test_emit_readable_is_for_povray(tmp_path: Path) -> None:
    result = run("emit", "tracer", SCENE, "--readable", "--out", tmp_path)
    assert result.exit_code == 2
    assert "vitrail emit povray --readable" in result.stderr


def test_emit_povray_writes_the_sky_that_its_texts_name(tmp_path: Path) -> None:
    write_image(tmp_path / "above.exr", np.ones((2, 4, 3)))
    sky = "environment: {file: above.exr}"
    text = SCENE.read_text(encoding="utf-8")
    (tmp_path / "scene.yaml").write_text(text.replace("lights:\n", f"lights:\n  - {{name: above, {sky}}}\n"))
    result = run("emit", "povray", tmp_path / "scene.yaml", "--out", tmp_path / "out")
    assert result.exit_code == 0, result.stderr
    texts = [path.read_text(encoding="ascii") for path in (tmp_path / "out").glob("*.pov")]
    named = {name for text in texts for name in re.findall(r'exr "([^"]*)"', text)}
    assert named and named == {path.name for path in (tmp_path / "out").glob("*.exr")}


def test_explain_prints_the_certificate() -> None:
    answer = json.loads(run("explain", SCENE, "--json").stdout)
    assert answer["certificate"]
    assert all(entry["phenomenon"] in list(Phenomenon) for entry in answer["certificate"])
    words = run("explain", SCENE).stdout
    assert "residual" in words
