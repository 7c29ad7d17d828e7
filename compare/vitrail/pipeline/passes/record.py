"""The run record of many passes: work is added up, memory is the most of any, the ledger of photons is the mean."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

LEDGER = ("emitted", "stored", "absorbed", "escaped", "truncated")


def with_record(total: Mapping[str, Any], record: Mapping[str, Any], passes: int) -> dict[str, Any]:
    """The record of ``passes`` finished passes and one more; ``total`` is empty before the first.

    What names the work (scene, settings, version) is that of the first pass. A warning whose words differ from one
    before in numbers only is not repeated.
    """
    if not passes:
        return dict(record)
    warnings = list(total["warnings"])
    known = {_without_numbers(warning) for warning in warnings}
    return {
        **total,
        "cpu_s": _added(total["cpu_s"], record["cpu_s"]),
        "wall_s": total["wall_s"] + record["wall_s"],
        "peak_memory_bytes": max(total["peak_memory_bytes"], record["peak_memory_bytes"]),
        "counters": _added(total["counters"], record["counters"]),
        "ledger": _mean_ledger(total["ledger"], record["ledger"], passes),
        "camera_ledger": _worse(total["camera_ledger"], record["camera_ledger"]),
        "warnings": [*warnings, *(each for each in record["warnings"] if _without_numbers(each) not in known)],
        "process": {
            **_added(total["process"], record["process"]),
            "peak_memory_bytes": max(each["process"]["peak_memory_bytes"] for each in (total, record)),
        },
    }


def cpu_seconds(record: Mapping[str, Any]) -> float:
    """Of the engine's own process, as every price in this program."""
    return float(record["process"]["cpu_s"])


def _added(total: Mapping[str, float], more: Mapping[str, float]) -> dict[str, float]:
    return {name: total[name] + more[name] for name in total}


def _mean_ledger(total: Mapping[str, Any], more: Mapping[str, Any], passes: int) -> dict[str, Any]:
    """Mean powers in W; the closure is the worst of any pass."""
    means = {
        name: [(a * passes + b) / (passes + 1) for a, b in zip(total[name], more[name], strict=True)] for name in LEDGER
    }
    return {**means, "closure": max(total["closure"], more["closure"])}


def _worse(one: Mapping[str, Any], other: Mapping[str, Any]) -> Mapping[str, Any]:
    """The ledger of camera paths of the pass that lost more to the limits; passes differ by noise alone."""
    return one if one["cut"] >= other["cut"] else other


def _without_numbers(words: str) -> str:
    return re.sub(r"[\d.e+-]*\d", "", words)
