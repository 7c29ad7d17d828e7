"""The records that are ``results.json``: one run, its scenes, their observations, every comparison with its verdict.

The report, the exit code and every machine reader take their numbers from here and compute none of their own. Records
are frozen, refuse unknown keys and hold finite numbers only, so a run that is written can always be read again.
Lengths are metres, radiance W sr^-1 m^-2, times CPU seconds; paths are relative to the folder of ``results.json``.
"""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Literal

from pydantic import Field, JsonValue

from vitrail.base.certificate_entry import CertificateEntry
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record, json_text, read_record, record_schema, write_record
from vitrail.judge.comparison import Bound, ObservationResult, Pair, Verdict
from vitrail.judge.purchase import PriceScore, Purchase
from vitrail.judge.scan_records import ScanResult

RESULTS_VERSION: Literal[1] = 1


class Status(StrEnum):
    """How far a scene came; only a judged one has verdicts."""

    JUDGED = "judged"
    GATE_FAILED = "gate_failed"
    SCENE_ERROR = "scene_error"
    NOT_TRANSLATABLE = "not_translatable"
    ENGINE_FAILED = "engine_failed"
    DEFECT = "defect"
    INTERRUPTED = "interrupted"


class GlobalMetric(Record):
    """A whole-image number, shown beside the verdicts; it has one itself only against a stored image of our own.

    ``floor`` is what noise alone would give; ``tolerance`` and ``verdict`` are about the distance from there.
    """

    pair: Pair | None = None
    metric: str
    value: float
    unit: str
    ideal: float
    floor: float | None = None
    tolerance: float | None = None
    verdict: Verdict | None = None
    settings: dict[str, JsonValue] = {}
    parts: dict[str, JsonValue] = {}
    caveats: tuple[str, ...] = ()


class Gate(Record):
    """A condition that must hold before any metric means anything."""

    gate: str
    passed: bool
    message: str


class PlanEntry(Record):
    """Whether the scene requires a phenomenon, what in the scene says so, and what modelling it costs."""

    phenomenon: Phenomenon
    required: bool
    evidence: tuple[str, ...] = ()
    cost: str = ""


class EngineRun(Record):
    """How one image was made. ``record`` is the engine's run record, word for word."""

    engine: str
    version: str
    cpu_s: float | None = None
    photon_cpu_s: float | None = None
    gather_cpu_s: float | None = None
    photons_emitted: int | None = None
    photons_stored: int | None = None
    photons_per_cpu_s: float | None = None
    gathers_per_cpu_s: float | None = None
    settings: dict[str, JsonValue] = {}
    warnings: tuple[str, ...] = ()
    record: dict[str, JsonValue] = {}


class Speed(Record):
    """The tracer's rate over POV-Ray's for one phase, in work per CPU second."""

    phase: str
    ratio: float
    unit: str


class ImageFiles(Record):
    """One side's pictures: the linear radiance, the display picture, and pictures of what else there is.

    ``content`` is the hash of the pixels as they would be stored: a decision about an image names it.
    """

    side: str
    exr: str
    png: str
    content: str = ""
    layers: dict[str, str] = {}


class MoreSamples(Record):
    """What deciding a scene in doubt would cost: ``factor`` times the samples, ``cpu_s`` CPU seconds more.

    Both are null where no number of samples decides. ``budget_s`` is what all scenes of the run may cost beyond their
    first look; ``affordable`` says whether what is left of it pays. The price is measured on this machine.
    """

    factor: float | None = None
    cpu_s: float | None = None
    budget_s: float = Field(ge=0)
    affordable: bool
    reason: str


class SceneResult(Record):
    """Everything about one scene. ``statement`` says how close it is known to agree, whatever its verdict;

    ``headline`` is the widest part of it. ``bound`` is that of its number which is most tolerances wide, at the level
    of the verdicts.
    """

    name: str
    title: str
    source: str
    scene_hash: str = ""
    status: Status
    message: str = ""
    width: int = 0
    height: int = 0
    exposure_stops: float = 0.0
    plan: tuple[PlanEntry, ...] = ()
    settings: dict[str, JsonValue] = {}
    certificate: tuple[CertificateEntry, ...] = ()
    engines: tuple[EngineRun, ...] = ()
    speed: tuple[Speed, ...] = ()
    images: tuple[ImageFiles, ...] = ()
    differences: dict[str, str] = {}
    gates: tuple[Gate, ...] = ()
    global_metrics: tuple[GlobalMetric, ...] = ()
    observations: tuple[ObservationResult, ...] = ()
    scan: ScanResult | None = None
    warnings: tuple[str, ...] = ()
    reproduce: str = ""
    verdict: Verdict | None = None
    bound: Bound | None = None
    statement: str = ""
    headline: str = ""
    more_samples: MoreSamples | None = None
    purchases: tuple[Purchase, ...] = ()
    exit_code: int = Field(ge=0)


class FalseAlarms(Record):
    """The chance that a suite without any deviation reports one, and how it is shared among the comparisons."""

    suite_rate: float = Field(gt=0, lt=1)
    comparisons: int = Field(ge=0)
    level: float = Field(gt=0, lt=1)
    correction: Literal["sidak"] = "sidak"


class Run(Record):
    """Where and how the run was made.

    All that may differ between two equal runs is in here, in the engine runs with their ``speed``, in the price of
    ``more_samples``, and in what the budget left untried of ``where``.
    """

    command: tuple[str, ...] = ()
    started: str = ""
    wall_s: float | None = None
    vitrail_version: str
    python: str = ""
    platform: str = ""
    processor: str = ""
    threads: int | None = None
    interrupted: bool = False


class Results(Record):
    """``results.json``. ``prices`` says how well the run foresaw what more samples cost, where it bought some."""

    vitrail_results: Literal[1] = RESULTS_VERSION
    run: Run
    false_alarms: FalseAlarms
    scenes: tuple[SceneResult, ...]
    counts: dict[str, int] = {}
    verdict: Verdict | None
    statement: str = ""
    prices: PriceScore | None = None
    exit_code: int = Field(ge=0)


def write_results(results: Results, path: Path) -> None:
    """Write ``results.json``: sorted keys, two spaces, so that two runs can be compared line by line."""
    write_record(results, path, indent=2)


def read_results(path: Path) -> Results:
    return read_record(Results, path)


def results_schema() -> dict[str, JsonValue]:
    """The JSON Schema of ``results.json``, committed as ``references/results.schema.json``."""
    return record_schema(Results, "Vitrail results")


if __name__ == "__main__":
    print(json_text(results_schema(), indent=2), end="")
