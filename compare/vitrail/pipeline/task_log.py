"""The memory of a study: finished tasks survive SIGKILL, and the finished files do not tell how often it was killed.

While a study runs, each finished task is one line appended and flushed to ``journal.jsonl``; a line torn by a kill is
dropped at the next start, so at most the running task is lost. When every task has a row, ``samples.jsonl.gz``
(results, in the order of the plan) and ``costs.jsonl`` are written whole and renamed into place.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from pathlib import Path

from vitrail.base.journal import append_line, whole_lines
from vitrail.base.packed import read_packed, write_packed
from vitrail.pipeline.task import Row, Task

SAMPLES, COSTS = "samples.jsonl.gz", "costs.jsonl"


class TaskLog:
    """Rows of one study in folder ``out``."""

    def __init__(self, out: Path) -> None:
        self.out = out
        self.journal = out / "journal.jsonl"
        out.mkdir(parents=True, exist_ok=True)
        self.rows = {row.key: row for row in whole_lines(self.journal, _row_of)}

    def missing(self, tasks: Iterable[Task]) -> list[Task]:
        """The tasks that have no row yet, each key once, in the given order."""
        seen: set[str] = set(self.rows)
        result = []
        for task in tasks:
            if task.key not in seen:
                seen.add(task.key)
                result.append(task)
        return result

    def append(self, row: Row) -> None:
        """Remember a finished task durably before anything else happens."""
        append_line(self.journal, {"result": row.result_line(), "cost": row.cost_line()})
        self.rows[row.key] = row

    def finish(self, tasks: Sequence[Task]) -> list[Row]:
        """Write the study's files in the order of its plan, and return the rows in that order."""
        ordered = [self.rows[key] for key in dict.fromkeys(task.key for task in tasks)]
        write_packed(self.out / SAMPLES, "".join(row.result_line() + "\n" for row in ordered))
        write_packed(self.out / COSTS, "".join(row.cost_line() + "\n" for row in ordered))
        return ordered


def read_rows(out: Path) -> list[Row]:
    """Rows of a finished study, for analysis without rendering; raises FileNotFoundError before it has finished."""
    costs = {record["key"]: record["cost"] for record in _lines(out / COSTS)}
    return [
        Row(r["key"], r["kind"], r["spec"], r.get("result"), r.get("failure"), costs.get(r["key"], {}))
        for r in _lines(out / SAMPLES)
    ]


def _lines(path: Path) -> list[dict]:
    return [json.loads(line) for line in read_packed(path).splitlines()]


def _row_of(record: dict) -> Row:
    result, cost = json.loads(record["result"]), json.loads(record["cost"])
    return Row(result["key"], result["kind"], result["spec"], result.get("result"), result.get("failure"), cost["cost"])
