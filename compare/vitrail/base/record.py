"""Records: results as types, written as JSON in one way, with a schema that other programs can hold them to."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel, ConfigDict, JsonValue

from vitrail.base.packed import read_packed, write_packed


class Record(BaseModel):
    """Base of every record: immutable, finite, unknown keys refused, fields written as they are named."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


JsonObject = Mapping[str, Any]
"""A JSON object as other programs write it, which no record describes."""

R = TypeVar("R", bound=BaseModel)


def number_in(values: Mapping[str, JsonValue], name: str, default: float) -> float:
    """One number of an open part of a record, ``default`` where it is absent or null; TypeError for anything else."""
    value = values.get(name)
    if value is None:
        return default
    if not isinstance(value, int | float):
        raise TypeError(f"{name} is {value!r}, which is no number")
    return float(value)


def json_text(value: JsonValue, *, indent: int = 1) -> str:
    """JSON for a file: keys sorted and one value a line, so that two runs can be compared line by line.

    Raises ValueError for NaN and infinity.
    """
    return json.dumps(value, indent=indent, sort_keys=True, allow_nan=False) + "\n"


def record_text(record: BaseModel, *, indent: int = 1) -> str:
    """A record as the text of its file."""
    return json_text(record.model_dump(mode="json"), indent=indent)


def write_record(record: BaseModel, path: Path, *, indent: int = 1) -> None:
    """Write a record to a file that appears whole; ``.gz`` compresses it."""
    write_packed(path, record_text(record, indent=indent))


def read_record(kind: type[R], path: Path) -> R:
    """Read a record; raises FileNotFoundError, and pydantic's ValidationError for what is no such record."""
    return kind.model_validate_json(read_packed(path))


def record_schema(kind: type[BaseModel], title: str) -> dict[str, JsonValue]:
    """The JSON Schema of a record as it is written."""
    schema = kind.model_json_schema(mode="serialization")
    return {**schema, "$schema": "https://json-schema.org/draft/2020-12/schema", "title": title}
