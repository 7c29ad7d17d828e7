"""The records of the mutants: what each mutant was reported as, ``mutants.json``, and ``limits.json``."""

from __future__ import annotations

from typing import Literal

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record
from vitrail.judge.comparison import AblationOutcome, Verdict
from vitrail.study.mutants.mutant import Place


class Reported(Record):
    """What a run is diagnosed as: the phenomenon named, the engine blamed, everything that deviates, and the witness.

    All are empty where nothing deviates; ``engine`` is null where no closed form decides.
    """

    reported: Phenomenon | None = None
    engine: str | None = None
    deviating: tuple[Phenomenon, ...] = ()
    scene: str = ""


class Witness(Record):
    """The number that is furthest beyond its tolerance, with the half width of its interval, in ``unit``."""

    metric: str
    difference: float
    half_width: float
    tolerance: float
    unit: str


class AblatedWitness(Record):
    """What ablation says of the witness: the suspects it leaves, and the outcome of everything switched off."""

    suspects: tuple[Phenomenon, ...]
    ablations: dict[str, AblationOutcome]


class Alarm(Record):
    """Whether one number over the picture would have stopped the run, and on which scenes."""

    caught: bool
    scenes: tuple[str, ...]


class Injection(Reported):
    """The result of one task: the scenes a mutant changes, those that a gate stopped, and what was reported."""

    touched: tuple[str, ...] = ()
    stopped: tuple[str, ...] = ()
    witness: Witness | None = None
    where: AblatedWitness | None = None
    alone: dict[str, Alarm] = {}


class MutantEntry(Injection):
    """One mutant: what was injected into which engine, and what came of it; ``failure`` if nothing could."""

    name: str
    place: Place
    what: str
    injected: Phenomenon
    injected_engine: str
    failure: str | None

    @property
    def suspects(self) -> tuple[Phenomenon, ...]:
        return self.where.suspects if self.where else ()

    def without(self, *outcomes: AblationOutcome) -> tuple[str, ...]:
        """What was switched off with one of these outcomes."""
        return tuple(
            off for off, outcome in (self.where.ablations if self.where else {}).items() if outcome in outcomes
        )

    @property
    def suspicion(self) -> Literal["named", "among", "none", "wrong"]:
        """Whether the suspects are the injected phenomenon, hold it, are none, or are others."""
        if self.suspects == (self.injected,):
            return "named"
        if self.injected in self.suspects:
            return "among"
        return "wrong" if self.suspects else "none"

    def is_seen_by(self, metric: str) -> bool:
        """Whether one number over the picture would have noticed it."""
        return metric in self.alone and self.alone[metric].caught


class CleanAblations(Record):
    """Every ablation of the clean bench: how many, and the words of those whose engines are not at one."""

    count: int
    apart: dict[str, str]


class CleanBench(Reported):
    """The bench without any mutant; ``alone`` lists the scenes that a number over the picture calls different."""

    scenes: tuple[str, ...]
    alone: dict[str, tuple[str, ...]]
    ablated: CleanAblations


class Mutants(Record):
    """``mutants.json``; of all mutants so many are caught, named right, and left as the only suspect by ablation."""

    vitrail_mutants: Literal[3] = 3
    clean: CleanBench
    mutants: tuple[MutantEntry, ...]
    caught: int
    named: int
    located: int
    cpu_s: int

    @property
    def injected(self) -> list[Phenomenon]:
        """The phenomena that any mutant breaks, in the order of the vocabulary: the rows of the confusion matrix."""
        return [phenomenon for phenomenon in Phenomenon if any(m.injected is phenomenon for m in self.mutants)]

    @property
    def reported(self) -> list[Phenomenon]:
        """The phenomena that any mutant is reported as, in the order of the vocabulary."""
        return [phenomenon for phenomenon in Phenomenon if any(m.reported is phenomenon for m in self.mutants)]

    @property
    def columns(self) -> list[Phenomenon | None]:
        """The columns of the confusion matrix; None for mutants that escape, where any does."""
        return [*self.reported, *([None] if any(m.reported is None for m in self.mutants) else [])]

    def count(self, injected: Phenomenon, reported: Phenomenon | None) -> int:
        """One cell of the confusion matrix."""
        return sum(m.injected is injected and m.reported is reported for m in self.mutants)

    @property
    def share_named(self) -> float:
        return self.named / len(self.mutants)

    @property
    def blamed(self) -> list[MutantEntry]:
        """The mutants for which closed forms blame an engine."""
        return [entry for entry in self.mutants if entry.engine]

    @property
    def blamed_right(self) -> list[MutantEntry]:
        """Those of them for which it is the spoilt one."""
        return [entry for entry in self.blamed if entry.engine == entry.injected_engine]

    def suspected(self, suspicion: str) -> int:
        """For how many mutants ablation leaves suspects of this kind."""
        return sum(entry.suspicion == suspicion for entry in self.mutants)

    def noticed(self, metric: str) -> int:
        """How many mutants one number over the picture notices."""
        return sum(entry.is_seen_by(metric) for entry in self.mutants)


class LimitNumber(Record):
    """The number that sees a small defect best: how far off it is, and how far it may be."""

    metric: str
    unit: str
    difference: float
    ideal: float
    half_width: float
    tolerance: float
    verdict: Verdict


class LimitRow(Record):
    """One ``size`` (in ``unit``) of one defect, against POV-Ray and against the closed form."""

    name: str
    words: str
    size: float
    unit: str
    scene: str
    share: float
    against: dict[str, LimitNumber]


class DetectionLimits(Record):
    """``limits.json``; ``kept`` if each whole defect deviates, and no half of one agrees."""

    vitrail_limits: Literal[1] = 1
    rows: tuple[LimitRow, ...]
    kept: bool
