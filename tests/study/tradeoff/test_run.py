"""The trade-off as a command, on a scene that takes a second: rows, page, resuming, analysing again."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from vitrail.commands.tradeoff import tradeoff
from vitrail.pipeline.job import prepare
from vitrail.pipeline.task_log import read_rows
from vitrail.scene.load import load
from vitrail.study.tradeoff.knobs import matrix

pytestmark = [pytest.mark.povray, pytest.mark.tracer]

SCENES = Path(__file__).resolve().parents[3] / "scenes" / "calibration"


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
    samples = (tmp_path / "samples.jsonl.gz").read_bytes()
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
    assert (tmp_path / "samples.jsonl.gz").read_bytes() == samples


def test_without_a_closed_form_the_reference_states_its_own_error(program, tmp_path: Path) -> None:
    lonely = tmp_path / "lonely.yaml"
    lonely.write_text(
        (SCENES / "penumbra.yaml").read_text().replace("width: 120, height: 120", "width: 24, height: 24")
    )
    out = tmp_path / "out"
    arguments = [str(lonely), "--out", str(out), "--extent", "quick"]
    result = CliRunner().invoke(program, arguments)
    assert result.exit_code == 0, result.output
    assert [row.failure for row in read_rows(out) if row.failure] == []
    found = json.loads((out / "tradeoff.json").read_text())["phenomena"]["shadow"]
    assert found["reference"] == "converged rendering" and 0 < found["reference_error"] < 0.05
    assert "against a rendering that is itself known to" in result.output
    # The two renderings are kept by content, and asked for once.
    assert len(list((out / "reference").glob("*.exr"))) == 2


def test_a_scene_that_observes_nothing_is_refused_with_the_remedy(program, tmp_path: Path) -> None:
    blind = tmp_path / "blind.yaml"
    blind.write_text((SCENES / "slab_clear.yaml").read_text().split("observe:")[0])
    result = CliRunner().invoke(program, [str(blind), "--out", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert "add an `observe` entry" in result.output


@pytest.mark.parametrize(
    ("scene", "knobs"),
    [
        ("ball_lens", {"photons", "gather_radius_m", "solver", "image_scale", "samples"}),
        ("slab_tilted", {"samples", "max_reflections"}),
        (
            "prism_screen",
            {
                "photons",
                "gather_radius_m",
                "solver",
                "image_scale",
                "samples",
                "bands",
                "reference_mode",
                "max_transmissions",
            },
        ),
        ("tinted_pane_seen", {"samples", "max_transmissions", "reference_mode"}),
    ],
)
def test_only_knobs_with_a_meaning_are_turned(scene: str, knobs: set[str]) -> None:
    usual = prepare(load(SCENES / f"{scene}.yaml"))
    tried = [{**each.settings, **each.wishes} for each in matrix(usual, "quick")]
    names = {name for each in tried for name in each}
    own = usual.scene.transport.model_dump()
    assert not [each for each in tried for name in each if name in own and each[name] == own[name]], "tried twice"
    turned = {name for name in names if len({str(each.get(name)) for each in tried}) > 1}
    assert turned == knobs


def test_only_the_tracer_counts_light_in_pixels() -> None:
    tried = matrix(prepare(load(SCENES / "ball_lens.yaml")), "normal")
    for solver in ("light_bins", "beams"):
        assert {each.engine for each in tried if each.settings.get("solver") == solver} == {"tracer"}
    assert len({(each.engine, each.seed, each.label) for each in tried}) == len(tried)
