"""The records of predictions: ``predictions.json``."""

from __future__ import annotations

from pydantic import ConfigDict, RootModel

from vitrail.base.engine_name import EngineName
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record
from vitrail.study.tradeoff.knobs import KnobValue


class CostAndError(Record):
    """What settings cost in CPU seconds, and how wrong their image is."""

    cost_s: float
    error: float


class ScoredPrediction(Record):
    """One wish in one engine: the settings chosen for it, what the model said of them, and what fresh runs gave.

    One of ``target_error`` and ``budget_s`` is given. Without ``knobs`` the wish is out of reach.
    """

    phenomenon: Phenomenon
    target_error: float | None
    budget_s: float | None
    engine: EngineName
    knobs: dict[str, KnobValue] | None = None
    label: str = "out of reach"
    predicted: CostAndError | None = None
    measured: CostAndError | None = None


class Predictions(RootModel[tuple[ScoredPrediction, ...]]):
    """``predictions.json``, a list."""

    model_config = ConfigDict(frozen=True)
