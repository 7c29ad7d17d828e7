"""What one more look at some views would cost, from what the first look took, phase by phase and engine by engine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from vitrail.base.record import number_in
from vitrail.judge.records import EngineRun

PHOTON_PHASES = ("photon_pass", "photon_sort", "photon_order")
"""What grows as the number of photons."""

GATHER_GROWTH = 2 / 3
"""A kernel of fixed photons^(-1/6) radius holds photons^(2/3) photons, each of which a gather adds up."""

GATHERING = 0.5
"""The share of an engine's camera phase that is gathering, where it cannot tell the two apart."""


def paid_s(engines: Sequence[EngineRun]) -> float:
    """CPU seconds that a look took: both engines, and the ordering of photons between them, which is ours."""
    return sum((engine.cpu_s or 0.0) + _phases(engine).get("photon_order", 0.0) for engine in engines)


def price_s(engines: Sequence[EngineRun], photons: float, samples: Mapping[str, float]) -> float:
    """CPU seconds of both engines for ``photons`` times the photons and, by view, so many times the samples."""
    return sum(_engine_s(engine, photons, samples) for engine in engines)


def _engine_s(engine: EngineRun, photons: float, samples: Mapping[str, float]) -> float:
    """One engine: its photons once, then every view. Each gather finds more of more photons."""
    phases = _phases(engine)
    shot = sum(phases.get(name, 0.0) for name in PHOTON_PHASES)
    found = photons**GATHER_GROWTH if engine.photons_stored else 1.0
    taken: Any = engine.record.get("views") or ()
    views = {str(view["name"]): view["cpu_s"] for view in taken}
    # What an engine does not tell apart is the picture, or at most all that its camera phase made.
    camera = {name: phases.get(name, 0.0) for name in ("camera", "gather")}
    drawn = sum(_view_s(views.get(name, camera), factor, found) for name, factor in samples.items())
    return phases.get("build", 0.0) + shot * photons + drawn


def _phases(engine: EngineRun) -> Mapping[str, float]:
    """CPU seconds of an engine by phase, as its run record has them."""
    written: Any = engine.record.get("cpu_s") or {}
    return {str(name): number_in(written, name, 0.0) for name in written}


def _view_s(cpu_s: Mapping[str, Any], samples: float, found: float) -> float:
    """One view; what is in no phase is starting the program and reading the scene, which stays."""
    camera, gather = number_in(cpu_s, "camera", 0.0), number_in(cpu_s, "gather", 0.0)
    start = max(number_in(cpu_s, "total", 0.0) - camera - gather, 0.0)
    if gather == 0:
        camera, gather = (1 - GATHERING) * camera, GATHERING * camera
    return start + samples * (camera + gather * found)
