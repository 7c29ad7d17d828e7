"""Every metric has a name that people know, and a bound is never rounded below itself."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.thresholds import own_references, read_thresholds
from vitrail.metrics.plain_names import PLAIN_NAMES, SUBJECTS, in_words


def test_every_judged_metric_has_a_plain_name_and_no_other_has() -> None:
    rules = read_thresholds(own_references() / "thresholds.yaml")
    judged = {metric.split(".")[0] for each in (rules.metrics, *rules.phenomena.values()) for metric in each}
    assert set(PLAIN_NAMES) == judged


def test_every_phenomenon_has_a_subject() -> None:
    assert set(SUBJECTS) == set(Phenomenon)


@pytest.mark.parametrize(
    ("metric", "amount", "ideal", "words"),
    [
        ("flux_ratio.red", 0.0041, 1.0, "0.41 %"),
        ("flux_ratio.red", 0.00411, 1.0, "0.42 %"),
        ("caustic_flux.red", 0.5, 50.0, "1.0 %"),
        ("mean_radiance.red", 0.003, 0.0, "0.0030"),
        ("centroid_shift.u", 0.00058, 0.0, "0.58 mm"),
        ("centroid_shift.u", 0.0000123, 0.0, "13 µm"),
        ("edge_place.u", 0.25, 1.0, "0.25 m"),
        ("place_deg.red", 0.021, 38.0, "0.021°"),
        ("delta_e_2000", 0.31, 0.0, "ΔE 0.31"),
        ("optical_depth_shift.red", 0.004, 0.0, "0.40 %"),
        ("flux_ratio.red", 0.0, 1.0, "0 %"),
        ("flux_ratio.red", 3.401, 1.0, "350 %"),
        ("flux_ratio.red", 0.0999, 1.0, "10 %"),
    ],
)
def test_a_bound_is_written_in_the_measure_people_read(metric: str, amount: float, ideal: float, words: str) -> None:
    assert in_words(metric, amount, ideal) == words


def test_a_tolerance_is_rounded_to_the_nearest() -> None:
    assert in_words("flux_ratio.red", 0.00352, 1.0, up=False) == "0.35 %"


def test_the_names_have_one_home() -> None:
    """No other file of the package maps families of metrics to words."""
    package = Path(own_references()).parent / "compare" / "vitrail"
    keyed = [
        path.name
        for path in package.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Dict)
        and len({key.value for key in node.keys if isinstance(key, ast.Constant)} & set(PLAIN_NAMES)) > 3
    ]
    assert set(keyed) == {"plain_names.py"}
