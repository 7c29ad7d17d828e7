"""The records of the stability atlas: what each task leaves, and ``atlas.json``."""

from __future__ import annotations

from typing import Literal

from vitrail.base.engine_name import EngineName
from vitrail.base.record import Record

Number = int | float
"""A value along an axis; a whole number stays one."""


class AtlasReading(Record):
    """What an engine made of one value: null for a number that is not finite, and the engine's words if it refused.

    ``digits`` are the decimal digits kept, between 0 and the 16 of a double.
    """

    value: Number
    measured: Number | None
    expected: Number | None
    deviation: float | None
    digits: float
    holds: bool
    words: str


class MeasuredRange(Record):
    """The result of one task: ``last_holding`` and ``first_failing`` bracket the limit, null where there is none."""

    last_holding: Number | None = None
    first_failing: Number | None = None
    readings: tuple[AtlasReading, ...] = ()


class EngineRange(MeasuredRange):
    """One engine on one axis, with the deviation that counts as holding and, where known, why its range ends.

    ``failure`` holds the words of a task that gave no range at all.
    """

    tolerance: float
    tolerance_reason: str
    limit: str
    failure: str | None

    @property
    def fails(self) -> bool:
        """Whether the range ends before the last value tried."""
        return self.failure is None and self.first_failing is not None

    @property
    def digits_kept(self) -> float:
        """The fewest digits that any holding reading kept."""
        return min((reading.digits for reading in self.readings if reading.holds), default=0.0)


class AtlasAxis(Record):
    """One quantity made extreme from ``first`` to ``last``, and the invariant that must survive it."""

    name: str
    quantity: str
    unit: str
    invariant: str
    first: Number
    last: Number
    engines: dict[EngineName, EngineRange]


class Atlas(Record):
    """``atlas.json``."""

    vitrail_atlas: Literal[1] = 1
    axes: tuple[AtlasAxis, ...]

    def held(self, engine: EngineName) -> int:
        """How many quantities an engine holds to the last value tried."""
        found = [axis.engines[engine] for axis in self.axes]
        return sum(each.failure is None and each.first_failing is None for each in found)
