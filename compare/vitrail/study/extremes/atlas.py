"""The atlas as a study: a task for each axis and engine, a record of all ranges, the minimal scenes of each failure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from vitrail.base.engine_name import EngineName
from vitrail.base.progress import Progress, silent
from vitrail.base.record import JsonObject, write_record
from vitrail.base.whole_file import write_whole
from vitrail.engines.engine_build import engine_build
from vitrail.pipeline.campaign import Campaign, run_campaign
from vitrail.pipeline.task import Row, Task
from vitrail.study.extremes.axis import ENGINES, Axis
from vitrail.study.extremes.ball_axes import BALL_AXES
from vitrail.study.extremes.incidence_axes import INCIDENCE_AXES
from vitrail.study.extremes.index_axes import INDEX_AXES
from vitrail.study.extremes.light_axes import LIGHT_AXES
from vitrail.study.extremes.measure import probe_of
from vitrail.study.extremes.records import Atlas, AtlasAxis, AtlasReading, EngineRange, MeasuredRange
from vitrail.study.extremes.search import Range, Reading, binary, find_limit, geometric, whole
from vitrail.study.extremes.size_axes import SIZE_AXES

AXES: tuple[Axis, ...] = (*SIZE_AXES, *LIGHT_AXES, *BALL_AXES, *INDEX_AXES, *INCIDENCE_AXES)
STACKS = ("depth", "photon_depth")
"""Axes whose failing scenes are hundreds of panes: they are written when asked for, and not kept in the repository."""


def atlas_tasks(axes: Sequence[Axis] = AXES) -> list[Task]:
    """One task an axis and engine; the key holds what its result depends on."""
    builds = {engine: engine_build(engine) for engine in ENGINES}
    return [
        Task("range", {"axis": axis.name, "engine": engine, "build": builds[engine], "definition": _definition(axis)})
        for axis in axes
        for engine in ENGINES
    ]


def run_atlas(out: Path, *, jobs: int = 1, axes: Sequence[Axis] = AXES, progress: Progress = silent) -> Atlas:
    """Measure what is missing in ``out`` and write atlas.json and scenes/; returns the atlas."""
    tasks = atlas_tasks(axes)
    rows = run_campaign(Campaign(tasks, {"range": measure_range}), out, jobs=jobs, progress=progress)
    atlas = Atlas(axes=tuple(_atlas_axis(axis, rows) for axis in axes))
    write_scenes(out / "scenes", atlas)
    write_record(atlas, out / "atlas.json")
    return atlas


def measure_range(spec: JsonObject) -> tuple[JsonObject, JsonObject]:
    """The work of one task: walk the axis in the engine and bisect to the first failing value."""
    axis = next(axis for axis in AXES if axis.name == spec["axis"])
    between = whole if axis.whole else binary if axis.is_binary and spec["engine"] == EngineName.TRACER else geometric
    found = find_limit(list(axis.values), probe_of(axis, spec["engine"]), between)
    return _measured_range(found).model_dump(mode="json"), {}


def _definition(axis: Axis) -> JsonObject:
    """What makes a stored range stale: the walked values, the tolerances and both scene texts."""
    return {
        "values": list(axis.values),
        "tolerance": {engine: tolerance.value for engine, tolerance in axis.tolerance.items()},
        "scene": axis.scene(axis.values[0]),
        "sdl": axis.sdl(axis.values[0]),
        "pixels": axis.pixels,
        "photons": axis.photons,
    }


def _measured_range(found: Range) -> MeasuredRange:
    readings = tuple(_atlas_reading(reading) for reading in found.readings)
    return MeasuredRange(last_holding=found.last_holding, first_failing=found.first_failing, readings=readings)


def _atlas_reading(reading: Reading) -> AtlasReading:
    finite = math.isfinite(reading.measured)
    return AtlasReading(
        value=reading.value,
        measured=reading.measured if finite else None,
        expected=reading.expected if math.isfinite(reading.expected) else None,
        deviation=reading.deviation if finite else None,
        digits=_digits(reading.deviation) if finite else 0.0,
        holds=reading.holds,
        words=reading.words,
    )


def _digits(deviation: float) -> float:
    """Decimal digits kept, between 0 and the 16 of a double."""
    return 16.0 if deviation <= 0 else min(16.0, max(0.0, -math.log10(deviation)))


def _atlas_axis(axis: Axis, rows: Sequence[Row]) -> AtlasAxis:
    found = {row.spec["engine"]: row for row in rows if row.spec["axis"] == axis.name}
    return AtlasAxis(
        name=axis.name,
        quantity=axis.quantity,
        unit=axis.unit,
        invariant=axis.invariant,
        first=axis.values[0],
        last=axis.values[-1],
        engines={engine: _engine_range(axis, engine, row) for engine, row in found.items()},
    )


def _engine_range(axis: Axis, engine: EngineName, row: Row) -> EngineRange:
    """One engine's range, with what the axis knows of it."""
    return EngineRange(
        **dict(MeasuredRange.model_validate(row.result or {})),
        tolerance=axis.tolerance[engine].value,
        tolerance_reason=axis.tolerance[engine].reason,
        limit=axis.limit.get(engine, ""),
        failure=row.failure,
    )


def write_scenes(folder: Path, atlas: Atlas) -> None:
    """The scene of each first failure in both languages, so that anybody can see it fail."""
    axes = {axis.name: axis for axis in AXES}
    for record in atlas.axes:
        for engine, found in record.engines.items():
            if found.first_failing is not None:
                axis, stem = axes[record.name], folder / f"{record.name}-{engine}"
                write_whole(stem.with_suffix(".yaml"), axis.scene(found.first_failing))
                write_whole(stem.with_suffix(".pov"), axis.sdl(found.first_failing))
