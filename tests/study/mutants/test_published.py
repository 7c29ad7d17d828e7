"""The published mutants keep the promises: all caught, nine in ten named right, the smallest defects seen."""

from __future__ import annotations

from tests.study.published import ROOT, published
from vitrail.study.equal_runs import RATES
from vitrail.study.mutants.catalogue import MUTANTS
from vitrail.study.mutants.limits import LIMITS, SHARES, is_kept


def stored(name: str):
    return published(f"mutants/{name}.json")


def test_every_mutant_is_caught_and_nine_in_ten_are_named_right() -> None:
    found = stored("mutants")
    assert [entry.name for entry in found.mutants] == [mutant.name for mutant in MUTANTS]
    assert [entry.name for entry in found.mutants if entry.reported is None or entry.failure] == []
    assert found.named >= 0.9 * len(MUTANTS) and len(MUTANTS) >= 25
    assert found.clean.reported is None
    wrong = [entry.name for entry in found.mutants if entry.engine not in (None, entry.injected_engine)]
    assert wrong == [], "a closed form blames the engine that is right"


def test_ablation_never_suspects_only_others_and_names_most() -> None:
    found = stored("mutants")
    assert [entry.name for entry in found.mutants if entry.suspicion == "wrong"] == []
    assert found.located == found.suspected("named")
    assert found.located >= 0.6 * len(MUTANTS), "several suspects are honest, but they must not be the rule"


def test_one_number_over_the_picture_misses_some_of_them() -> None:
    entries = stored("mutants").mutants
    for metric in ("ssim", "flip", "relmse"):
        assert any(not entry.is_seen_by(metric) for entry in entries), metric


def test_the_smallest_defects_were_seen_and_halves_did_not_pass() -> None:
    rows = stored("limits").rows
    assert [(row.name, row.share) for row in rows] == [(each.name, share) for each in LIMITS for share in SHARES]
    assert all(set(row.against) == {"povray", "truth"} and is_kept(row) for row in rows)


def test_the_rates_of_false_alarms_were_kept() -> None:
    found = stored("equal_runs")
    assert found.failures == () and [row.rate for row in found.rates] == list(RATES)
    assert all(row.suites >= 200 and row.p_value >= 0.01 for row in found.rates)
    # The page on false alarms quotes the same numbers.
    page = (ROOT / "docs" / "false-alarms.md").read_text()
    for row in found.rates:
        assert f"| {100 * row.rate:g} % | {row.alarms} of {row.suites} |" in page
