"""The records of the study of plans: what each task leaves, and ``plans.json``.

A variant is named ``everything``, ``plan``, or by the phenomenon that it is without. Times are CPU seconds.
"""

from __future__ import annotations

from typing import Literal

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record

EVERYTHING, PLANNED = "everything", "plan"


class ImageDifference(Record):
    """How far a variant's image is from the plan's.

    ``relative_l1`` is the relative L1 difference. ``sigmas`` is the root mean square over pixels of the difference over
    its standard error (1 if noise alone parts the images), null where halves give no noise; ``outside_noise`` is the
    relative L1 difference of the pixels without noise.
    """

    relative_l1: float
    same_bits: bool
    sigmas: float | None
    outside_noise: float


class Variants(Record):
    """The result of one task: the phenomena a scene requires, and the difference of every variant from its plan."""

    required: tuple[Phenomenon, ...] = ()
    differences: dict[str, ImageDifference] = {}


class VariantCosts(Record):
    """The cost of one task: the CPU seconds of every run by variant."""

    cpu_s: dict[str, tuple[float, ...]] = {}


class PlannedScene(Variants):
    """One scene: ``cpu_s`` is the least of each variant's runs, ``runs_cpu_s`` are those of both whole variants."""

    name: str
    failure: str | None
    cpu_s: dict[str, float]
    runs_cpu_s: dict[str, tuple[float, ...]]
    slower: bool

    def costs_s(self, phenomenon: Phenomenon) -> float | None:
        """What modelling a phenomenon costs; None where that is less than the runs scatter."""
        return self._beyond_scatter(self.cpu_s[PLANNED] - self.cpu_s[phenomenon])

    @property
    def saved_s(self) -> float | None:
        """What the plan saves; None where that is less than the runs scatter, or nothing is required."""
        return self._beyond_scatter(self.cpu_s[EVERYTHING] - self.cpu_s[PLANNED]) if self.required else None

    def _beyond_scatter(self, difference_s: float) -> float | None:
        scatter_s = max((max(runs) - min(runs) for runs in self.runs_cpu_s.values()), default=0.0)
        return difference_s if abs(difference_s) > scatter_s else None


class PlanSummary(Record):
    """All scenes together: how many are the same to the bit, which are slower, and the sums of ``cpu_s``."""

    scenes: int
    same_bits: int
    slower: tuple[str, ...]
    cpu_s: dict[str, float]


class Plans(Record):
    """``plans.json``; ``removed`` says how each phenomenon is taken out."""

    vitrail_plans: Literal[2] = 2
    scenes: tuple[PlannedScene, ...]
    summary: PlanSummary
    removed: dict[Phenomenon, str]

    @property
    def required(self) -> list[Phenomenon]:
        """Every phenomenon that any scene requires, in the order of the vocabulary."""
        return [phenomenon for phenomenon in Phenomenon if any(phenomenon in scene.required for scene in self.scenes)]
