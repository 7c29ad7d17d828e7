"""What a person reads after a comparison: how close first, the verdict second, and nothing that was not asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.commands.command_line import SCENE, run
from tests.report.synthetic import write_run
from vitrail.base.exit_code import ExitCode
from vitrail.commands.verdict_table import print_results
from vitrail.judge.records import Results


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Results:
    """Scenes that agree, deviate, stay open, and one whose engine failed."""
    return write_run(tmp_path_factory.mktemp("run"))


def printed(results: Results, capsys: pytest.CaptureFixture[str], *, verbose: bool = False) -> list[str]:
    print_results(results, Path("out/index.html"), verbose=verbose)
    return capsys.readouterr().out.splitlines()


def test_each_scene_is_one_line_that_begins_with_how_close(
    results: Results, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = printed(results, capsys)[: len(results.scenes)]
    assert [text.split()[0] for text in lines] == ["alike", "apart", "unsure", "broken"]
    assert [text.split()[-1] for text in lines] == ["agrees", "deviates", "inconclusive", "engine_failed"]
    assert lines[0].startswith("alike   The caustic agrees to within 0.60 %")
    assert "agrees to within 2.2 % (tolerance 2.0 % not yet shown)" in lines[2]
    assert "Parse Error" in lines[3]


def test_one_block_tells_what_deviates_or_failed_and_nothing_else(
    results: Results, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = printed(results, capsys)
    block = lines[len(results.scenes) : -2]
    assert not any("unsure" in text or "alike" in text for text in block)
    assert any(
        text.startswith("apart.ring caustic: tracer-vs-povray flux_ratio.red deviates by 30 %") for text in block
    )
    assert any("where: in caustic" in text for text in block)
    assert any(text.startswith("  again: vitrail compare scenes/apart.yaml") for text in block)


def test_it_ends_with_what_to_open(results: Results, capsys: pytest.CaptureFixture[str]) -> None:
    *_, count, page = printed(results, capsys)
    assert count.startswith("1 of 4 scenes agrees; 1 deviates") and count.endswith(
        "-v tells what would decide the rest."
    )
    assert page == "Open out/index.html"


def test_v_tells_what_is_open_and_what_would_decide_it(results: Results, capsys: pytest.CaptureFixture[str]) -> None:
    lines = printed(results, capsys, verbose=True)
    (flux, *_) = [text for text in lines if text.startswith("unsure.ring caustic: tracer-vs-povray")]
    assert flux.endswith("times the samples would decide")
    assert "-v" not in lines[-2]


@pytest.mark.parametrize(
    ("found", "options", "code"),
    [
        (ExitCode.INCONCLUSIVE, (), 5),
        (ExitCode.INCONCLUSIVE, ("--allow-open",), 0),
        (ExitCode.DEVIATES, ("--allow-open",), 1),
        (ExitCode.ENGINE_FAILED, ("--allow-open",), 4),
    ],
)
def test_what_is_open_ends_with_0_only_where_that_was_allowed(
    results: Results,
    found: ExitCode,
    options: tuple[str, ...],
    code: int,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    ended = results.model_copy(update={"exit_code": found})
    monkeypatch.setattr("vitrail.pipeline.compare.compare", lambda *_: ended)
    monkeypatch.setattr("vitrail.report.build.build_report", lambda out: out / "index.html")
    assert run("compare", SCENE, "--out", tmp_path, *options).exit_code == code
