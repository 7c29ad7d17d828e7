"""The page of mutants says what its data say, and the data keep the promises: all caught, nine in ten named right."""

from __future__ import annotations

import json
from pathlib import Path

from vitrail.report.mutants_text import mutants_text
from vitrail.study.equal_runs import RATES
from vitrail.study.mutants.catalogue import MUTANTS
from vitrail.study.mutants.limits import LIMITS, SHARES, is_kept, limits_table

FOLDER = Path(__file__).resolve().parents[3] / "docs" / "studies" / "mutants"


def stored(name: str):
    return json.loads((FOLDER / f"{name}.json").read_text())


def test_the_page_is_that_of_the_data() -> None:
    page = mutants_text(stored("mutants"), limits_table(stored("limits")), stored("equal_runs"))
    assert (FOLDER / "README.md").read_text() == page


def test_every_mutant_is_caught_and_nine_in_ten_are_named_right() -> None:
    found = stored("mutants")
    assert [entry["name"] for entry in found["mutants"]] == [mutant.name for mutant in MUTANTS]
    assert [entry["name"] for entry in found["mutants"] if entry["reported"] is None or entry["failure"]] == []
    assert found["named"] >= 0.9 * len(MUTANTS) and len(MUTANTS) >= 25
    assert found["clean"]["reported"] is None
    wrong = [entry["name"] for entry in found["mutants"] if entry["engine"] not in (None, entry["injected_engine"])]
    assert wrong == [], "a closed form blames the engine that is right"


def test_ablation_never_suspects_only_others_and_names_most() -> None:
    found = stored("mutants")
    suspects = {entry["name"]: (entry["where"] or {}).get("suspects", []) for entry in found["mutants"]}
    assert [
        n["name"] for n in found["mutants"] if suspects[n["name"]] and n["injected"] not in suspects[n["name"]]
    ] == []
    assert found["located"] == sum(suspects[e["name"]] == [e["injected"]] for e in found["mutants"])
    assert found["located"] >= 0.6 * len(MUTANTS), "several suspects are honest, but they must not be the rule"


def test_one_number_over_the_picture_misses_some_of_them() -> None:
    entries = stored("mutants")["mutants"]
    for metric in ("ssim", "flip", "relmse"):
        assert any(not entry["alone"][metric]["caught"] for entry in entries), metric


def test_the_smallest_defects_were_seen_and_halves_did_not_pass() -> None:
    rows = stored("limits")["rows"]
    assert [(row["name"], row["share"]) for row in rows] == [(each.name, share) for each in LIMITS for share in SHARES]
    assert all(set(row["against"]) == {"povray", "truth"} and is_kept(row) for row in rows)


def test_the_rates_of_false_alarms_were_kept() -> None:
    found = stored("equal_runs")
    assert found["failures"] == [] and [row["rate"] for row in found["rates"]] == list(RATES)
    assert all(row["suites"] >= 200 and row["p_value"] >= 0.01 for row in found["rates"])
    # The page on false alarms quotes the same numbers.
    page = (FOLDER.parents[1] / "false-alarms.md").read_text()
    for row in found["rates"]:
        assert f"| {100 * row['rate']:g} % | {row['alarms']} of {row['suites']} |" in page
