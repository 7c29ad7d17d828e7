"""Records are written in one way, read back the same, and refuse what JSON cannot hold."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest
from pydantic import ValidationError

from vitrail.base.record import Record, json_text, number_in, read_record, record_schema, record_text, write_record


class Point(Record):
    """Two numbers and a word."""

    y: float
    x: float
    name: str = "tête"


def test_keys_are_sorted_and_stand_on_lines_of_their_own() -> None:
    assert record_text(Point(y=2.0, x=0.1)) == '{\n "name": "t\\u00eate",\n "x": 0.1,\n "y": 2.0\n}\n'
    assert record_text(Point(y=2.0, x=0.1), indent=2).splitlines()[1].startswith("  ")


def test_what_is_written_reads_back_the_same(tmp_path: Path) -> None:
    write_record(Point(y=1 / 3, x=-0.0), tmp_path / "new" / "point.json")
    assert read_record(Point, tmp_path / "new" / "point.json") == Point(y=1 / 3, x=-0.0)


def test_unknown_keys_infinities_and_changes_are_refused(tmp_path: Path) -> None:
    (tmp_path / "point.json").write_text('{"x": 1, "y": 2, "z": 3}')
    with pytest.raises(ValidationError, match="z"):
        read_record(Point, tmp_path / "point.json")
    with pytest.raises(ValidationError, match="finite"):
        Point(y=float("inf"), x=0.0)
    with pytest.raises(ValidationError, match="frozen"):
        Point(y=1.0, x=0.0).x = 2.0  # type: ignore[misc]
    with pytest.raises(ValueError, match="not JSON compliant"):
        json_text(float("nan"))


def test_the_schema_accepts_what_is_written_and_nothing_more() -> None:
    schema = record_schema(Point, "A point")
    assert schema["title"] == "A point"
    jsonschema.validate(json.loads(record_text(Point(y=2.0, x=0.1))), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"x": 1.0, "y": 2.0, "z": 3.0}, schema)


def test_a_number_of_an_open_part_has_a_default_and_is_a_number() -> None:
    assert number_in({"radius_m": 1}, "radius_m", 0.5) == 1.0
    assert number_in({"radius_m": None}, "radius_m", 0.5) == number_in({}, "radius_m", 0.5) == 0.5
    with pytest.raises(TypeError, match="radius_m is 'wide'"):
        number_in({"radius_m": "wide"}, "radius_m", 0.5)
