"""Pairs that differ in the seed alone raise no more alarms than the rate says, and narrow intervals are found out."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from tests.pipeline.doubles import CARD, FormulaEngine
from vitrail.base.record import read_record
from vitrail.engines.base import Rendering
from vitrail.images.exr import write_image
from vitrail.scene.load import load
from vitrail.study.equal_runs import EqualRuns, PairNumber, alarm_table, equal_runs

pytestmark = pytest.mark.slow


def suites(narrow: float, count: int = 400, numbers: int = 10) -> list[list[PairNumber]]:
    """Normal differences of size 1 whose stated standard error is ``narrow``."""
    draws = np.random.default_rng(3).standard_normal((count, numbers))
    return [
        [PairNumber(difference=float(x), standard_error=narrow, degrees_of_freedom=1e9) for x in suite]
        for suite in draws
    ]


def test_right_intervals_keep_their_rate() -> None:
    table = {row.rate: row for row in alarm_table(suites(narrow=1.0))}
    assert all(row.p_value > 0.01 for row in table.values())
    assert table[0.2].alarms == pytest.approx(0.2 * 400, abs=3 * (0.2 * 0.8 * 400) ** 0.5)


def test_intervals_a_fifth_too_narrow_are_found_out() -> None:
    assert {row.rate: row for row in alarm_table(suites(narrow=0.8))}[0.2].p_value < 1e-6


@dataclass
class NoisyEngine(FormulaEngine):
    """White noise from the seed of the settings."""

    def render(self, lowered, out_dir, *, threads=0, progress=None):  # type: ignore[no-untyped-def,override]
        rng = np.random.default_rng(lowered["settings"]["seed"])
        views = {}
        for view in lowered["views"]:
            size = (view["image"]["height"], view["image"]["width"], 3)
            a, b = (0.5 * (1 + 0.1 * rng.standard_normal(size)) for _ in "ab")
            views[view["name"]] = Path(out_dir) / f"tracer.{view['name']}.exr"
            write_image(views[view["name"]], (a + b) / 2, half_a=a, half_b=b)
        return Rendering(Path(out_dir) / "tracer.exr", {"engine": "tracer", "version": "1"}, views)


def test_pairs_are_measured_once_and_remembered(tmp_path: Path) -> None:
    (tmp_path / "card.yaml").write_text(CARD)
    loaded = load(tmp_path / "card.yaml")
    out = tmp_path / "out"
    found = equal_runs(loaded, out, NoisyEngine("tracer"), pairs=30, overrides={})
    assert found.failures == () and [row.suites for row in found.rates] == [30, 30, 30]
    assert all(row.p_value > 0.001 for row in found.rates)
    assert read_record(EqualRuns, out / "equal_runs.json") == found
    broken = NoisyEngine("tracer")
    broken.render = None  # type: ignore[assignment,method-assign]
    assert equal_runs(loaded, out, broken, pairs=30, overrides={}) == found, "finished pairs are not rendered again"
