"""Predictions are scored on runs of the chosen settings with fresh seeds, and remembered."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, cast

import pytest
import typer

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import read_record
from vitrail.commands.tradeoff import _aim
from vitrail.pipeline.task import Row
from vitrail.report.tradeoff_page import write_tradeoff_page
from vitrail.scene.load import load
from vitrail.study.tradeoff.analysis import analyse_rows
from vitrail.study.tradeoff.measure import Measure
from vitrail.study.tradeoff.predict import FRESH_SEEDS, Aim, predict, prediction_line
from vitrail.study.tradeoff.predictions import Predictions
from vitrail.study.tradeoff.records import Tradeoff

pytestmark = pytest.mark.tracer

BALL = Path(__file__).resolve().parents[3] / "scenes" / "calibration" / "ball_lens.yaml"


class Law:
    """An engine of 0.1 s + 1 us a photon, with an error of 2 / sqrt(photons), half of it in an image twice as large."""

    def __init__(self) -> None:
        self.specs: list[dict[str, Any]] = []

    def setting(self, spec: dict[str, Any]) -> tuple[dict[str, Any], dict[str, float]]:
        self.specs.append(dict(spec))
        size = 2 / math.sqrt(spec["settings"]["photons"]) / spec["wishes"].get("image_scale", 1)
        error = {"phenomenon": "caustic", "observation": "c", "metric": "m", "error": size, "standard_error": 0.0}
        return {"errors": [error]}, {"cpu_s": 0.1 + 1e-6 * spec["settings"]["photons"]}


def _study() -> Tradeoff:
    rows = []
    for photons in (10_000, 100_000, 1_000_000):
        spec = {"engine": "tracer", "settings": {"photons": photons}, "wishes": {"image_scale": 2}, "seed": 1}
        result, cost = Law().setting(spec)
        rows.append(Row(str(photons), "setting", spec, result, None, cost))
    return analyse_rows(rows, "ball_lens", "Ball")


def test_chosen_settings_are_run_with_fresh_seeds_and_scored(tmp_path: Path) -> None:
    law, found = Law(), _study()
    aims = [Aim(Phenomenon.CAUSTIC, error=0.004), Aim(Phenomenon.CAUSTIC, budget_s=0.6)]
    records = predict(load(BALL), tmp_path, found, cast(Measure, law), aims)
    by_error, by_budget = (record for record in records.root if record.engine == "tracer")
    # (1 / 0.004)^2 photons make 0.4 % at a scale of 2.
    assert by_error.knobs == {"image_scale": 2, "photons": pytest.approx(62_500, abs=1)}
    assert by_error.measured.error == pytest.approx(0.004, rel=1e-4)
    assert by_budget.measured.cost_s == pytest.approx(0.6, rel=1e-4)
    assert {spec["seed"] for spec in law.specs} == set(FRESH_SEEDS)
    assert all(spec["wishes"] == {"image_scale": 2} for spec in law.specs)
    # POV-Ray is not in this study: its row says so and costs no run.
    assert [record.label for record in records.root if record.engine == "povray"] == ["out of reach"] * 2
    assert "predicted 0.4 % in 0.16 CPU s, measured 0.4 % in 0.16 CPU s" in prediction_line(by_error)
    assert read_record(Predictions, tmp_path / "predictions.json") == records
    runs = len(law.specs)
    assert predict(load(BALL), tmp_path, found, cast(Measure, law), aims) == records and len(law.specs) == runs
    assert "how they came out" in write_tradeoff_page(tmp_path, found, records.root).read_text()


@pytest.mark.parametrize("wish", ["caustic=0.01", "refraction=2", "refraction", "refraction=little"])
def test_a_wish_that_means_nothing_is_refused(wish: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit) as refused:
        _aim(wish, [Phenomenon.REFRACTION])
    assert refused.value.exit_code == 2
    assert f"--target-error {wish}: " in capsys.readouterr().err
