"""The committed schemas are those of the records, and every published file fits the schema of its kind."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from tests.study.published import ROOT, STUDIES
from vitrail.base.packed import kind_of, read_packed
from vitrail.base.record import read_record, record_text
from vitrail.study.schemas import RECORDS, schema_text

SCHEMAS = STUDIES / "schemas"
FILES = [path for name in RECORDS for path in sorted(STUDIES.glob(f"*/{name}.json"))] + [
    ROOT / "docs/agreement.json.gz"
]


@pytest.mark.parametrize("name", RECORDS)
def test_the_committed_schema_is_that_of_the_record(name: str) -> None:
    stale = "is old; write it again with `python -m vitrail.study.schemas docs/studies/schemas`"
    assert (SCHEMAS / f"{name}.schema.json").read_text() == schema_text(name), f"{name}.schema.json {stale}"


def test_every_kind_of_file_is_published_and_no_schema_is_left_over() -> None:
    assert {kind_of(path) for path in FILES} == set(RECORDS)
    assert {path.name for path in SCHEMAS.iterdir()} == {f"{name}.schema.json" for name in RECORDS}


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_published_file_fits_its_schema_and_is_written_as_records_are(path: Path) -> None:
    schema = json.loads((SCHEMAS / f"{kind_of(path)}.schema.json").read_text())
    jsonschema.validate(json.loads(read_packed(path)), schema)
    assert record_text(read_record(RECORDS[kind_of(path)], path)) == read_packed(path)
