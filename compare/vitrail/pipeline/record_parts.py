"""Plans, certificates and run records in the form that ``results.json`` has for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from vitrail.judge.records import EngineRun, PlanEntry, Speed
from vitrail.plan.plan import Plan


def plan_records(plan: Plan) -> tuple[PlanEntry, ...]:
    return tuple(
        PlanEntry(phenomenon=phenomenon, required=entry.required, evidence=entry.evidence, cost=entry.cost)
        for phenomenon, entry in plan.entries.items()
    )


def engine_record(record: Mapping[str, Any]) -> EngineRun:
    """The page's view of a run record, and the record itself.

    A rate is work over the CPU seconds of its phase. Photons are counted when they are stored: POV-Ray also shoots
    past the glass, which helps no picture. It gathers while it traces camera rays and cannot tell the two apart, so
    for both engines the gather rate is over camera and gather together.
    """
    cpu, counters = record.get("cpu_s", {}), record.get("counters", {})
    photon_cpu_s = _sum(cpu, ("photon_pass",))
    camera_cpu_s = _sum(cpu, ("camera", "gather"))
    emitted = counters.get("photons_emitted") or None
    stored = counters.get("photons_stored") or None
    queries = counters.get("gather_queries") or None
    return EngineRun(
        engine=record["engine"],
        version=str(record.get("version", "")),
        cpu_s=cpu.get("total"),
        photon_cpu_s=photon_cpu_s if emitted else None,
        gather_cpu_s=camera_cpu_s if queries else None,
        photons_emitted=emitted,
        photons_stored=stored,
        photons_per_cpu_s=_rate(stored, photon_cpu_s),
        gathers_per_cpu_s=_rate(queries, camera_cpu_s),
        settings=dict(record.get("settings", {})),
        warnings=tuple(record.get("warnings", ())),
        record=dict(record),
    )


def speed_records(engines: Sequence[EngineRun]) -> tuple[Speed, ...]:
    """The tracer's rates over POV-Ray's, where both have them."""
    by_name = {engine.engine: engine for engine in engines}
    tracer, povray = by_name.get("tracer"), by_name.get("povray")
    if tracer is None or povray is None:
        return ()
    phases = (
        # POV-Ray sorts within its photon time and cannot tell; ours is timed apart and left out.
        ("photon pass", "photons_per_cpu_s", "photons stored per CPU second (emit, trace, store)"),
        ("gather", "gathers_per_cpu_s", "gathers per CPU second (camera rays and gathering)"),
    )
    found = []
    for phase, name, unit in phases:
        ours, theirs = getattr(tracer, name), getattr(povray, name)
        if ours and theirs:
            found.append(Speed(phase=phase, ratio=ours / theirs, unit=unit))
    return tuple(found)


def _sum(mapping: Mapping[str, float], keys: Sequence[str]) -> float:
    return float(sum(mapping.get(key) or 0.0 for key in keys))


def _rate(work: int | None, cpu_s: float) -> float | None:
    return work / cpu_s if work and cpu_s > 0 else None
