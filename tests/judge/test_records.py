"""The records are ``results.json``: what is written can be read again, and the published schema is theirs."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest
from pydantic import ValidationError

from vitrail.judge.comparison import Interval, Pair
from vitrail.judge.records import FalseAlarms, Results, Run, read_results, results_schema, write_results

SCHEMA = Path(__file__).parents[2] / "references" / "results.schema.json"


def small_results() -> Results:
    return Results(
        run=Run(vitrail_version="0"),
        false_alarms=FalseAlarms(suite_rate=0.01, comparisons=0, level=0.99),
        scenes=(),
        verdict=None,
        exit_code=2,
    )


def test_written_results_read_back_the_same(tmp_path: Path) -> None:
    write_results(small_results(), tmp_path / "results.json")
    assert read_results(tmp_path / "results.json") == small_results()


def test_published_schema_is_that_of_the_records() -> None:
    assert json.loads(SCHEMA.read_text()) == json.loads(json.dumps(results_schema())), (
        "references/results.schema.json is old; write it again with `python -m vitrail.judge.records`"
    )


def test_written_results_fit_the_published_schema(tmp_path: Path) -> None:
    write_results(small_results(), tmp_path / "results.json")
    jsonschema.validate(json.loads((tmp_path / "results.json").read_text()), json.loads(SCHEMA.read_text()))


def test_no_record_holds_a_number_that_json_cannot() -> None:
    with pytest.raises(ValidationError, match="finite"):
        Interval(low=float("nan"), high=1.0, level=0.99, method="none")


def test_a_pair_names_its_two_sides() -> None:
    assert [(pair.candidate, pair.reference) for pair in Pair][:2] == [("tracer", "povray"), ("tracer", "truth")]
    assert all(pair.value == f"{pair.candidate}-vs-{pair.reference}" for pair in Pair)
