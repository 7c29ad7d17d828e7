"""Every metric has a tolerance, every tolerance a reason, and only a certificate widens one."""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.reference_files import ReferencesError
from vitrail.judge.rules import Rule
from vitrail.judge.thresholds import ThresholdError, read_thresholds

ROOT = Path(__file__).parents[2]
PUBLISHED = ROOT / "references" / "thresholds.yaml"
HEAD = "version: 1\nsuite_false_alarm_rate: {value: 0.01, reason: because}\n"


def written(folder: Path, rules: str) -> Path:
    path = folder / "thresholds.yaml"
    path.write_text(HEAD + rules)
    return path


def test_the_published_rules_all_have_reasons() -> None:
    found = read_thresholds(PUBLISHED)
    rules = {**found.metrics, **{f"{p}.{m}": rule for p, own in found.phenomena.items() for m, rule in own.items()}}
    assert len(rules) > 40
    for name, rule in rules.items():
        assert len(rule.reason.split()) >= 3, f"{name}: a reason has more than two words"


def test_a_rule_of_the_phenomenon_replaces_that_of_the_metric(tmp_path: Path) -> None:
    rules = "metrics: {flux: {relative: 0.1, reason: a}}\nphenomena: {caustic: {flux: {relative: 0.2, reason: b}}}\n"
    found = read_thresholds(written(tmp_path, rules))
    assert found.rule(Phenomenon.CAUSTIC, "flux.red").amount == 0.2
    assert found.rule(Phenomenon.DIFFUSION, "flux.red").amount == 0.1
    with pytest.raises(ThresholdError, match="no rule for the metric `width`"):
        found.rule(Phenomenon.CAUSTIC, "width.u")


@pytest.mark.parametrize(
    ("rules", "says"),
    [
        ("metrics: {flux: {relative: 0.1}}", "flux has no reason"),
        ("metrics: {flux: {relative: 0.1, absolute: 1, reason: a}}", "flux takes one of"),
        ("metrics: {flux: {relative: -1, reason: a}}", "flux.relative is -1"),
        ("metrics: {flux: {relativ: 1, reason: a}}", "flux.relativ is unknown; a rule takes one of relative, of_patch"),
        ("metrics: {flux: {relative: wide, reason: a}}", "flux.relative is 'wide'; write"),
        ("metrics: {flux: {relative: 0.1, as: width}}", "`as: width` names no metric with a reason of its own"),
        ("phenomena: {caustik: {flux: {relative: 0.1, reason: a}}}", "phenomena.caustik"),
    ],
)
def test_a_wrong_rule_is_refused(tmp_path: Path, rules: str, says: str) -> None:
    with pytest.raises(ThresholdError, match=says):
        read_thresholds(written(tmp_path, rules))


def test_a_rule_may_have_the_reason_of_another_metric_and_more(tmp_path: Path) -> None:
    """A reason that only begins with the word is a reason of its own."""
    rules = """metrics:
  flux: {relative: 0.1, reason: "as flux, which is what it is"}
  mean: {relative: 0.1, as: flux}
  depth: {absolute: 0.1, as: flux, reason: of the lit side}
"""
    found = read_thresholds(written(tmp_path, rules)).metrics
    assert found["flux"].reason == "as flux, which is what it is"
    assert found["mean"].reason == "as flux: as flux, which is what it is"
    assert found["depth"].reason == "as flux, of the lit side: as flux, which is what it is"


def test_a_missing_file_of_thresholds_fails(tmp_path: Path) -> None:
    with pytest.raises(ReferencesError, match="cannot be read"):
        read_thresholds(tmp_path / "thresholds.yaml")


def test_each_kind_of_rule_finds_its_size() -> None:
    assert Rule("relative", 0.01, "r").part(ideal=-5.0, half_edge_m=2.0).amount == pytest.approx(0.05)
    assert Rule("of_patch", 0.01, "r").part(ideal=0.0, half_edge_m=2.0).amount == pytest.approx(0.02)
    assert Rule("absolute", 0.01, "r").part(ideal=7.0, half_edge_m=2.0).amount == 0.01


def test_a_residual_is_worth_what_the_rule_says() -> None:
    assert Rule("relative", 0.01, "r").widening(0.001, ideal=5.0, half_edge_m=2.0) == pytest.approx(0.005)
    assert Rule("of_patch", 0.01, "r").widening(0.001, ideal=0.0, half_edge_m=2.0) == pytest.approx(0.002)
    assert Rule("absolute", 0.5, "r").widening(0.001, ideal=0.0, half_edge_m=2.0) == 0.0
    assert Rule("of_patch", 0.5, "r", certificate=0.5).widening(0.001, 0.0, 2.0) == pytest.approx(0.001)
    assert Rule("absolute", 0.5, "r", certificate=40.0).widening(0.001, 0.0, 2.0) == pytest.approx(0.04)
