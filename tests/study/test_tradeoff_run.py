"""The trade-off as a command, on a scene that takes a second: rows, page, resuming, analysing again."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from vitrail.commands.tradeoff import tradeoff
from vitrail.plan.analyse import analyse
from vitrail.scene.load import load
from vitrail.study.task_log import read_rows
from vitrail.study.tradeoff.knobs import matrix

SCENES = Path(__file__).resolve().parents[2] / "scenes" / "calibration"


@pytest.fixture(scope="module")
def program():
    import typer

    app = typer.Typer()
    app.command()(tradeoff)
    return app


def test_one_command_measures_analyses_and_resumes(program, tmp_path: Path) -> None:
    arguments = [str(SCENES / "slab_tilted.yaml"), "--out", str(tmp_path), "--extent", "quick"]
    first = CliRunner().invoke(program, arguments)
    assert first.exit_code == 0, first.output
    samples = (tmp_path / "samples.jsonl").read_bytes()
    assert {row.spec["engine"] for row in read_rows(tmp_path)} == {"tracer", "povray"}
    assert not [row for row in read_rows(tmp_path) if row.failure]
    # Both engines reach 5 % at once: the slab is exact to the half floats of POV-Ray's image.
    found = json.loads((tmp_path / "tradeoff.json").read_text())["phenomena"]["refraction"]
    assert all(found["engines"][engine]["best_error"] < 6e-4 for engine in ("tracer", "povray"))
    assert found["sentence"] in first.output
    assert "What accuracy costs" in (tmp_path / "index.html").read_text()
    # Nothing is rendered again, and the analysis alone gives the same.
    again = CliRunner().invoke(program, [*arguments, "--analyse-only"])
    assert again.exit_code == 0, again.output
    assert (tmp_path / "samples.jsonl").read_bytes() == samples


def test_a_scene_without_truth_is_refused_with_the_remedy(program, tmp_path: Path) -> None:
    lonely = tmp_path / "lonely.yaml"
    lonely.write_text((SCENES / "slab_tilted.yaml").read_text())
    result = CliRunner().invoke(program, [str(lonely), "--out", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert "analytic.yaml has no closed form" in result.output


@pytest.mark.parametrize(
    ("scene", "knob"),
    [("ball_lens", "photons"), ("slab_tilted", "samples"), ("prism_screen", "bands")],
)
def test_only_knobs_with_a_meaning_are_turned(scene: str, knob: str) -> None:
    plan = analyse(load(SCENES / f"{scene}.yaml").scene)
    tried = matrix(plan, 0.01, "quick")
    assert len({str({**each.settings, **each.transport}.get(knob)) for each in tried}) > 1
    if scene == "slab_tilted":
        assert not any("photons" in each.settings for each in tried)
