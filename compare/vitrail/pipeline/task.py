"""One unit of a study: what is to be done, named by its content, and the row that remains of it.

A row has two parts. ``result`` depends only on the task (scene, engine version, settings, seed) and is the same bits
whenever the task is run; ``cost`` (CPU seconds, memory) is measured and differs from run to run. They are stored in two
files, so that *the study's results are reproducible* is a statement about whole files.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field

from vitrail.base.canonical_json import json_line
from vitrail.base.record import JsonObject

TIMEOUT_S = 900.0
"""Wall time that one rendering of a study may take; one that takes longer is a row that says so."""


@dataclass(frozen=True)
class Task:
    """``kind`` names the code that runs it, ``spec`` is everything that code needs, as plain JSON values."""

    kind: str
    spec: JsonObject

    @property
    def key(self) -> str:
        """Content hash: equal tasks have equal keys, on any machine and in any session."""
        return hashlib.sha256(json_line({"kind": self.kind, "spec": dict(self.spec)}).encode()).hexdigest()[:24]


@dataclass(frozen=True)
class Row:
    """What remains of a task: its result, or the words with which it failed; and what it cost."""

    key: str
    kind: str
    spec: JsonObject
    result: JsonObject | None = None
    failure: str | None = None
    cost: JsonObject = field(default_factory=dict)

    def result_line(self) -> str:
        """The reproducible part as one JSON line."""
        record = {"key": self.key, "kind": self.kind, "spec": dict(self.spec)}
        return json_line(record | ({"failure": self.failure} if self.failure is not None else {"result": self.result}))

    def cost_line(self) -> str:
        """The measured part as one JSON line."""
        return json_line({"key": self.key, "cost": dict(self.cost)})
