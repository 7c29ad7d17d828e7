"""``pytest --vitrail`` run by pytest on scenes of its own, with the real tracer and with or without POV-Ray."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.pipeline.doubles import CARD

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
RULES = (ROOT / "references" / "thresholds.yaml").read_text()
ALONE = {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
"""The plugin is named on the command line, so that it is loaded once whether or not the package is installed."""

TRUTH = """
version: 1
scenes: {card: {card: {mean_radiance.red: {value: VALUE, formula: d E / pi, source: a book}}}}
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A project of somebody else: one scene, one closed form, thresholds of its own."""
    (tmp_path / "references").mkdir()
    (tmp_path / "references" / "thresholds.yaml").write_text(RULES)
    (tmp_path / "references" / "analytic.yaml").write_text(TRUTH.replace("VALUE", "0.5"))
    (tmp_path / "scenes").mkdir()
    (tmp_path / "scenes" / "card.yaml").write_text(CARD)
    (tmp_path / "scenes" / "other.yaml").write_text("name: no scene\n")
    return tmp_path


def pytest_in(project: Path, *options: str, povray: bool = False) -> subprocess.CompletedProcess[str]:
    path = os.environ["PATH"] if povray else "/nowhere"
    known = {**os.environ, "PYTHONPATH": str(ROOT / "compare"), "PATH": path, **ALONE}
    command = [sys.executable, "-m", "pytest", "-p", "vitrail.pytest_plugin", "-p", "no:cacheprovider", "-rN"]
    options = ("--vitrail", "scenes", "--vitrail-quality", "draft", *options)
    return subprocess.run(
        [*command, *options], cwd=project, env=known, capture_output=True, text=True, timeout=300, check=False
    )


def test_observations_are_tests_and_other_yaml_is_left_alone(project: Path) -> None:
    done = pytest_in(project, "-v")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "scenes/card.yaml::card PASSED" in done.stdout
    assert "scenes/card.yaml::whole_image PASSED" in done.stdout
    assert "2 passed" in done.stdout
    assert (project / "vitrail-report" / "index.html").is_file()


def test_a_deviation_fails_with_its_numbers_and_its_line(project: Path) -> None:
    (project / "references" / "analytic.yaml").write_text(TRUTH.replace("VALUE", "0.6"))
    done = pytest_in(project, "--junitxml", "junit.xml")
    assert done.returncode == 1
    line = CARD.splitlines().index(next(row for row in CARD.splitlines() if row.startswith("observe"))) + 1
    assert f"card.yaml:{line}: The " in done.stdout
    assert "it is 0.5 W sr^-1 m^-2, should be 0.6" in done.stdout
    assert "Traceback" not in done.stdout
    case = ElementTree.parse(project / "junit.xml").find(".//testcase[@name='card']")
    assert case is not None and case.find("failure") is not None
    names = {each.get("name"): each.get("value") for each in case.iter("property")}
    assert float(str(names["tracer-vs-truth mean_radiance.red"])) == pytest.approx(0.5, rel=1e-6)


def test_povray_takes_part_where_it_is_installed(project: Path) -> None:
    done = pytest_in(project, povray=True)
    assert done.returncode == 0, done.stdout
    (scene,) = json.loads((project / "vitrail-report" / "results.json").read_text())["scenes"]
    pairs = {each["pair"] for each in scene["observations"][0]["comparisons"]}
    assert pairs == {"tracer-vs-povray", "tracer-vs-truth", "povray-vs-truth"}


def test_nothing_to_hold_a_scene_against_is_no_success(project: Path) -> None:
    (project / "references" / "analytic.yaml").unlink()
    done = pytest_in(project)
    assert done.returncode == 1 and "there is nothing to hold it against" in done.stdout


def test_a_missing_reference_that_was_asked_for_fails(project: Path) -> None:
    done = pytest_in(project, "--vitrail-against", "stored")
    assert done.returncode == 1 and "there is no stored reference; accept one with `vitrail bless" in done.stdout


def test_a_wrong_scene_is_an_error_of_collection_with_its_place(project: Path) -> None:
    (project / "scenes" / "wrong.yaml").write_text(CARD.replace("diffuse:", "difuse:"))
    done = pytest_in(project)
    assert done.returncode == 2
    assert "wrong.yaml:6:" in done.stdout and "did you mean `diffuse`?" in done.stdout


def test_no_scene_collected_is_no_success(project: Path) -> None:
    (project / "scenes" / "card.yaml").unlink()
    assert pytest_in(project).returncode == pytest.ExitCode.NO_TESTS_COLLECTED


def test_the_plugin_costs_a_foreign_session_nothing(tmp_path: Path) -> None:
    (tmp_path / "test_it.py").write_text("import sys\ndef test_it():\n    assert 'numpy' not in sys.modules\n")
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-p",
        "vitrail.pytest_plugin",
        "-p",
        "no:cacheprovider",
        "test_it.py",
    ]
    known = {**os.environ, "PYTHONPATH": str(ROOT / "compare"), **ALONE}
    done = subprocess.run(command, cwd=tmp_path, env=known, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stdout
