"""Whole comparisons with the real engines: the tracer as it was built, POV-Ray as it is installed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from vitrail.check.check import check_file
from vitrail.engines.base import EngineFailure
from vitrail.engines.povray import Povray
from vitrail.engines.tracer import Tracer
from vitrail.judge.records import Results
from vitrail.pipeline.compare import compare
from vitrail.pipeline.request import Request
from vitrail.report.build import build_report

ROOT = Path(__file__).parents[2]
REFERENCES = ROOT / "references"

Compare = Callable[..., Results]


@pytest.fixture(scope="session", autouse=True)
def both_engines() -> None:
    """These tests are about the real programs: without one they fail, and say what to do."""
    for engine in (Tracer(), Povray()):
        try:
            engine.version()
        except EngineFailure as failure:
            pytest.fail(str(failure), pytrace=False)


@pytest.fixture
def compared(tmp_path: Path) -> Compare:
    """Compare scene files at draft quality into the test's own folder, and build the report."""

    def run(*scenes: Path, **rest: object) -> Results:
        loaded = [check_file(scene).scene_or_raise() for scene in scenes]
        options = {"quality": "draft", "threads": 2, "references": REFERENCES, **rest}
        results = compare(loaded, Request(out=tmp_path / "out", **options))  # type: ignore[arg-type]
        build_report(tmp_path / "out")
        return results

    return run
