"""The committed schemas are those of the records, and every published file fits the schema of its kind."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from tests.study.published import ROOT, STUDIES
from vitrail.base.record import read_record, record_text
from vitrail.study.schemas import RECORDS, schema_text

SCHEMAS = STUDIES / "schemas"
FILES = [path for name in RECORDS for path in sorted(STUDIES.glob(f"*/{name}.json"))] + [ROOT / "docs/agreement.json"]


@pytest.mark.parametrize("name", RECORDS)
def test_the_committed_schema_is_that_of_the_record(name: str) -> None:
    stale = "is old; write it again with `python -m vitrail.study.schemas docs/studies/schemas`"
    assert (SCHEMAS / f"{name}.schema.json").read_text() == schema_text(name), f"{name}.schema.json {stale}"


def test_every_kind_of_file_is_published_and_no_schema_is_left_over() -> None:
    assert {path.stem for path in FILES} == set(RECORDS)
    assert {path.name for path in SCHEMAS.iterdir()} == {f"{name}.schema.json" for name in RECORDS}


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_published_file_fits_its_schema_and_is_written_as_records_are(path: Path) -> None:
    jsonschema.validate(json.loads(path.read_text()), json.loads((SCHEMAS / f"{path.stem}.schema.json").read_text()))
    assert record_text(read_record(RECORDS[path.stem], path)) == path.read_text()
