"""The atlas as a study: a task for each axis and engine, a record of all ranges, the minimal scenes of each failure."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, get_args

from vitrail.engines.engine_build import engine_build
from vitrail.pipeline.queue import Progress, run_tasks
from vitrail.pipeline.task import Row, Task
from vitrail.pipeline.task_log import TaskLog
from vitrail.study.extremes.axis import AtlasEngine, Axis
from vitrail.study.extremes.ball_axes import BALL_AXES
from vitrail.study.extremes.incidence_axes import INCIDENCE_AXES
from vitrail.study.extremes.index_axes import INDEX_AXES
from vitrail.study.extremes.light_axes import LIGHT_AXES
from vitrail.study.extremes.measure import probe_of
from vitrail.study.extremes.search import Range, Reading, binary, find_limit, geometric, whole
from vitrail.study.extremes.size_axes import SIZE_AXES

AXES: tuple[Axis, ...] = (*SIZE_AXES, *LIGHT_AXES, *BALL_AXES, *INDEX_AXES, *INCIDENCE_AXES)
ENGINES: tuple[AtlasEngine, ...] = get_args(AtlasEngine)


def atlas_tasks(axes: Sequence[Axis] = AXES) -> list[Task]:
    """One task an axis and engine; the key holds what its result depends on."""
    builds = {engine: engine_build(engine) for engine in ENGINES}
    return [
        Task("range", {"axis": axis.name, "engine": engine, "build": builds[engine], "definition": _definition(axis)})
        for axis in axes
        for engine in ENGINES
    ]


def run_atlas(
    out: Path, *, jobs: int = 1, axes: Sequence[Axis] = AXES, report: Callable[[Progress], None] = lambda p: None
) -> dict[str, Any]:
    """Measure what is missing in ``out`` and write atlas.json and scenes/; returns the atlas."""
    tasks = atlas_tasks(axes)
    rows = run_tasks(tasks, TaskLog(out), {"range": measure_range}, jobs=jobs, report=report)
    atlas = {"vitrail_atlas": 1, "axes": [_axis_record(axis, rows) for axis in axes]}
    _write_scenes(out / "scenes", axes, rows)
    (out / "atlas.json").write_text(json.dumps(atlas, indent=1, sort_keys=True, allow_nan=False) + "\n")
    return atlas


def measure_range(spec: Mapping[str, Any]) -> tuple[Mapping[str, Any], Mapping[str, float]]:
    """The work of one task: walk the axis in the engine and bisect to the first failing value."""
    axis = next(axis for axis in AXES if axis.name == spec["axis"])
    between = whole if axis.whole else binary if axis.is_binary and spec["engine"] == "tracer" else geometric
    found = find_limit(list(axis.values), probe_of(axis, spec["engine"]), between)
    return _range_record(found), {}


def _definition(axis: Axis) -> dict[str, Any]:
    """What makes a stored range stale: the walked values, the tolerances and both scene texts."""
    return {
        "values": list(axis.values),
        "tolerance": {engine: tolerance.value for engine, tolerance in axis.tolerance.items()},
        "scene": axis.scene(axis.values[0]),
        "sdl": axis.sdl(axis.values[0]),
        "pixels": axis.pixels,
        "photons": axis.photons,
    }


def _range_record(found: Range) -> dict[str, Any]:
    return {
        "last_holding": found.last_holding,
        "first_failing": found.first_failing,
        "readings": [_reading_record(reading) for reading in found.readings],
    }


def _reading_record(reading: Reading) -> dict[str, Any]:
    finite = math.isfinite(reading.measured)
    return {
        "value": reading.value,
        "measured": reading.measured if finite else None,
        "expected": reading.expected if math.isfinite(reading.expected) else None,
        "deviation": reading.deviation if finite else None,
        "digits": _digits(reading.deviation) if finite else 0.0,
        "holds": reading.holds,
        "words": reading.words,
    }


def _digits(deviation: float) -> float:
    """Decimal digits kept, between 0 and the 16 of a double."""
    return 16.0 if deviation <= 0 else min(16.0, max(0.0, -math.log10(deviation)))


def _axis_record(axis: Axis, rows: Sequence[Row]) -> dict[str, Any]:
    found = {row.spec["engine"]: row for row in rows if row.spec["axis"] == axis.name}
    return {
        "name": axis.name,
        "quantity": axis.quantity,
        "unit": axis.unit,
        "invariant": axis.invariant,
        "first": axis.values[0],
        "last": axis.values[-1],
        "engines": {
            engine: {
                "tolerance": axis.tolerance[engine].value,
                "tolerance_reason": axis.tolerance[engine].reason,
                "limit": axis.limit.get(engine, ""),
                "failure": row.failure,
                **(row.result or {}),
            }
            for engine, row in found.items()
        },
    }


def _write_scenes(folder: Path, axes: Sequence[Axis], rows: Sequence[Row]) -> None:
    """The scene of each first failure in both languages, so that anybody can see it fail."""
    folder.mkdir(exist_ok=True)
    for row in rows:
        failing = (row.result or {}).get("first_failing")
        if failing is None:
            continue
        axis = next(axis for axis in axes if axis.name == row.spec["axis"])
        stem = folder / f"{axis.name}-{row.spec['engine']}"
        stem.with_suffix(".yaml").write_text(axis.scene(failing))
        stem.with_suffix(".pov").write_text(axis.sdl(failing))
