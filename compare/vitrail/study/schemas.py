"""The JSON Schemas of all studies, committed in ``docs/studies/schemas``: what another program may rely on.

``python -m vitrail.study.schemas DIR`` writes them again.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

from pydantic import BaseModel

from vitrail.base.record import json_text, record_schema
from vitrail.base.whole_file import write_whole
from vitrail.study.agreement import Agreement
from vitrail.study.equal_runs import EqualRuns
from vitrail.study.extremes.records import Atlas
from vitrail.study.mutants.records import DetectionLimits, Mutants
from vitrail.study.tradeoff.plan_records import Plans
from vitrail.study.tradeoff.predictions import Predictions
from vitrail.study.tradeoff.records import Tradeoff

RECORDS: Mapping[str, type[BaseModel]] = {
    "agreement": Agreement,
    "atlas": Atlas,
    "equal_runs": EqualRuns,
    "limits": DetectionLimits,
    "mutants": Mutants,
    "plans": Plans,
    "predictions": Predictions,
    "tradeoff": Tradeoff,
}
"""The record of every published file, by the stem of its name."""


def schema_text(name: str) -> str:
    """The schema of one kind of file."""
    return json_text(record_schema(RECORDS[name], f"Vitrail {name.replace('_', ' ')}"))


if __name__ == "__main__":
    for each in RECORDS:
        write_whole(Path(sys.argv[1]) / f"{each}.schema.json", schema_text(each))
