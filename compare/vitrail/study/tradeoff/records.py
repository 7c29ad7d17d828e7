"""The records of a trade-off: what each task leaves, and ``tradeoff.json``.

Errors are relative and positive, costs are CPU seconds of the engine's own process, memory is in bytes.
"""

from __future__ import annotations

from typing import Literal

from pydantic import JsonValue

from vitrail.base.engine_name import EngineName
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record
from vitrail.study.statistics import Estimate, Setting
from vitrail.study.tradeoff.knobs import ENGINES, KnobValue, amount


class MeasuredError(Record):
    """How far one number of one observation is from the truth; relative, with its sign and its standard error."""

    observation: str
    phenomenon: Phenomenon
    metric: str
    error: float
    standard_error: float


class Errors(Record):
    """The result of one task: every error of one image."""

    errors: tuple[MeasuredError, ...] = ()

    def of(self, phenomenon: Phenomenon) -> list[MeasuredError]:
        return [error for error in self.errors if error.phenomenon is phenomenon]


class RunCost(Record):
    """What one run of an engine took."""

    cpu_s: float
    peak_memory_bytes: float = 0.0


class TriedSetting(Setting):
    """One setting of one engine, with its place on the Pareto front; ``knobs`` are its values by name."""

    on_front: bool
    at_knee: bool
    knobs: dict[str, KnobValue]
    peak_memory_bytes: float | None
    runs: int

    def amount(self, knob: str) -> float:
        """How much work a knob of work (photons, samples) asks for."""
        return amount(self.knobs, knob)


class Order(Record):
    """An order of convergence: slopes of logarithms ``along`` one knob, all others ``held``.

    A slope is null where a value is 0 and has no logarithm.
    """

    along: str
    held: str
    settings: int
    error: Estimate | None
    spread: Estimate | None
    cost: Estimate | None


class Price(Record):
    """CPU seconds for an error, and whether they are a price, an upper limit, or cannot be told."""

    status: Literal["reached", "at_most", "not_reached", "below_reference"]
    cpu_s: float | None


class EngineFront(Record):
    """All settings of one engine, and what follows from them by target error and by budget."""

    settings: tuple[TriedSetting, ...]
    orders: tuple[Order, ...]
    price_s: dict[str, Price]
    error_at_s: dict[str, float | None]
    best_error: float


class EqualError(Record):
    """What the same error costs in both engines; null for an engine that has no settings here."""

    target: float
    tracer: Price | None = None
    povray: Price | None = None
    povray_over_tracer: float | None


class EqualTime(Record):
    """The error that the same CPU seconds buy in both engines; null where nothing is that cheap."""

    budget_s: float
    tracer: float | None = None
    povray: float | None = None
    povray_over_tracer: float | None


class PhenomenonPrices(Record):
    """One phenomenon of one scene; ``reference_error`` is that of a converged rendering, null for a closed form."""

    engines: dict[EngineName, EngineFront]
    equal_error: tuple[EqualError, ...]
    equal_time: tuple[EqualTime, ...]
    reference: Literal["closed form", "converged rendering"]
    reference_error: float | None
    sentence: str

    @property
    def by_engine(self) -> list[tuple[EngineName, EngineFront]]:
        """The engines that were tried, the tracer first."""
        return [(engine, self.engines[engine]) for engine in ENGINES if engine in self.engines]


class FailedTask(Record):
    """A task that gave no errors, and the words with which it failed."""

    spec: dict[str, JsonValue]
    failure: str


class Tradeoff(Record):
    """``tradeoff.json``."""

    vitrail_tradeoff: Literal[2] = 2
    scene: str
    title: str
    phenomena: dict[Phenomenon, PhenomenonPrices]
    failures: tuple[FailedTask, ...]
