"""The example repository of docs/example, used as a stranger would: by pytest without POV-Ray, and by the action."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from ruamel.yaml import YAML

from tests.pytest_plugin.test_plugin import ROOT, pytest_in

pytestmark = pytest.mark.slow


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A copy of docs/example outside of this repository."""
    return Path(shutil.copytree(ROOT / "docs" / "example", tmp_path / "example"))


def action_in(repository: Path) -> tuple[subprocess.CompletedProcess[str], str]:
    """Run the comparing step of action.yml as the runner does: bash, inputs in the environment. Also the summary.

    The inputs are the defaults of the action but for those that the example's workflow gives.
    """
    read = YAML(typ="safe").load
    action = read((ROOT / "action.yml").read_text())
    workflow = read((repository / ".github" / "workflows" / "glass.yml").read_text())
    (use,) = [step for step in workflow["jobs"]["compare"]["steps"] if "vitrail/vitrail" in step.get("uses", "")]
    inputs = {name: entry["default"] for name, entry in action["inputs"].items()} | use["with"]
    step = action["runs"]["steps"][-1]
    given = {name: inputs[value.removeprefix("${{ inputs.").removesuffix(" }}")] for name, value in step["env"].items()}
    summary = repository / "summary.md"
    known = {"GITHUB_ACTION_PATH": str(ROOT), "GITHUB_STEP_SUMMARY": str(summary), "PYTHONPATH": str(ROOT / "compare")}
    command = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
    done = subprocess.run(
        command, cwd=repository, env={**os.environ, **known, **given}, capture_output=True, text=True, timeout=300
    )
    return done, summary.read_text() if summary.exists() else ""


def test_pytest_holds_the_example_against_its_formula_and_its_image_without_povray(repository: Path) -> None:
    done = pytest_in(repository, "--vitrail-against", "stored", "-v")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "scenes/pane.yaml::through PASSED" in done.stdout and "2 passed" in done.stdout
    results = (repository / "vitrail-report" / "results.json").read_text()
    assert '"tracer-vs-stored"' in results and '"tracer-vs-truth"' in results and "povray" not in results


def test_the_action_passes_the_example_and_annotates_a_broken_one(repository: Path) -> None:
    done, summary = action_in(repository)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "| agrees | coloured_transmission agrees |" in summary
    truth = repository / "references" / "analytic.yaml"
    truth.write_text(truth.read_text().replace("value: 0.36", "value: 0.37"))
    done, summary = action_in(repository)
    assert done.returncode == 1
    line = 1 + (repository / "scenes" / "pane.yaml").read_text().splitlines().index("observe:") + 1
    assert f"::error file=scenes/pane.yaml,line={line},title=pane.through deviates::" in done.stdout
    assert "mean_radiance.green deviates by" in done.stdout and "| pane | The tinted light" in summary


def test_an_image_by_another_version_is_compared_and_never_silently(repository: Path) -> None:
    provenance = repository / "references" / "pane" / "provenance.yaml"
    provenance.write_text(provenance.read_text().replace('version: "0.1.0"', 'version: "0.0.9"'))
    told = "the stored reference was made by tracer 0.0.9, this is 0.1.0"
    done = pytest_in(repository, "--vitrail-against", "stored")
    assert done.returncode == 0 and told in done.stdout and "1 warning" in done.stdout, done.stdout
    done, _ = action_in(repository)
    assert done.returncode == 0 and f"title=remark::{told}" in done.stdout


def test_a_scene_that_changed_since_its_image_was_accepted_says_so(repository: Path) -> None:
    scene = repository / "scenes" / "pane.yaml"
    scene.write_text(scene.read_text().replace("[0.9, 0.6, 0.2]", "[0.9, 0.6, 0.3]"))
    done, _ = action_in(repository)
    assert done.returncode == 2 and "the scene is now" in done.stderr and "bless again" in done.stderr
