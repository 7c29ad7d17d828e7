"""One number held against what it should be, and everything needed to believe the answer.

These are the inner records of ``results.json`` (the outer ones are in ``records.py``): an observation has comparisons
and profiles; a comparison has a value, an interval, a tolerance with its reasons, a verdict and, where it deviates,
its cause. Lengths are metres, radiance W sr^-1 m^-2.
"""

from __future__ import annotations

from enum import StrEnum
from typing import Literal

from pydantic import Field, JsonValue

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record
from vitrail.judge.noise_record import NoiseRecord
from vitrail.judge.view_record import ViewRecord


class Verdict(StrEnum):
    """What one comparison, observation, scene or run came to."""

    AGREES = "agrees"
    DEVIATES = "deviates"
    INCONCLUSIVE = "inconclusive"


class Pair(StrEnum):
    """Who is held against whom: the first is the candidate, the second what it should equal."""

    TRACER_POVRAY = "tracer-vs-povray"
    TRACER_TRUTH = "tracer-vs-truth"
    POVRAY_TRUTH = "povray-vs-truth"
    TRACER_STORED = "tracer-vs-stored"
    POVRAY_STORED = "povray-vs-stored"
    CANDIDATE_REFERENCE = "candidate-vs-reference"
    CANDIDATE_TRUTH = "candidate-vs-truth"
    REFERENCE_TRUTH = "reference-vs-truth"

    @property
    def candidate(self) -> str:
        return self.value.split("-vs-")[0]

    @property
    def reference(self) -> str:
        return self.value.split("-vs-")[1]


def maker(side: str) -> str:
    """The maker of an image, in the middle of a sentence."""
    return "POV-Ray" if side == "povray" else f"the {side}"


class Cause(StrEnum):
    """Where a deviation comes from."""

    TRANSLATION = "translation"
    NUMERICS = "numerics"
    NOISE = "noise"
    MODEL = "model"


class Attribution(Record):
    """The cause of a deviation and, where a closed form decides it, the engine that is wrong."""

    cause: Cause
    engine: str | None = None
    reason: str


class Interval(Record):
    """An interval of confidence ``level`` (0.999 means one in a thousand such intervals misses)."""

    low: float
    high: float
    level: float = Field(gt=0, le=1)
    method: str

    @property
    def half_width(self) -> float:
        return (self.high - self.low) / 2


class Bound(Record):
    """How closely a number is known to be what it should be: with confidence ``level`` it is off by ``amount`` at most.

    ``amount`` is in the comparison's unit; ``words`` are for people, relative where the metric is. ``over_tolerance``
    is the bound at the level of the verdict, in tolerances: 1 or less where the number agrees; null without one.
    """

    amount: float = Field(ge=0)
    level: float = Field(gt=0, lt=1)
    words: str
    over_tolerance: float | None = None


class TolerancePart(Record):
    """One share of a tolerance: the metric's threshold or its formula's, and what is allowed beside it.

    That is what the translation's certificate states, against a closed form what the image's resolution smooths, and
    what limits cut or POV-Ray drops of the light.
    """

    source: Literal["threshold", "reference", "certificate", "resolution", "cut", "dropped"]
    amount: float = Field(ge=0)
    reason: str


class Comparison(Record):
    """One number held against what it should be.

    ``value`` is the metric (a ratio, a shift, or a measured quantity where the other side is truth), ``ideal`` what
    perfect agreement gives, ``difference = value - ideal``. ``interval`` is that of the difference at the corrected
    level of the run. ``tolerance`` is the sum of ``tolerance_parts``. ``sample_factor``, of an inconclusive
    comparison, is how many times the samples would decide it; null where no number of samples can. ``statement`` says
    in words how close it is known to be, and ``bound`` as a number; records of older versions lack both.
    """

    pair: Pair
    metric: str
    unit: str
    value: float
    ideal: float
    ideal_source: str = ""
    difference: float
    interval: Interval
    tolerance: float = Field(ge=0)
    tolerance_parts: tuple[TolerancePart, ...] = ()
    verdict: Verdict
    bound: Bound | None = None
    statement: str = ""
    sample_factor: float | None = None
    reason: str
    attribution: Attribution | None = None
    settings: dict[str, JsonValue] = {}
    parts: dict[str, JsonValue] = {}
    caveats: tuple[str, ...] = ()


class Curve(Record):
    """One line of a profile: samples at the profile's positions, with the standard error of each where known."""

    side: str
    values: tuple[float, ...]
    standard_error: tuple[float, ...] = ()


class Profile(Record):
    """Radiance along one direction of a patch, averaged across the other, for every side there is."""

    along: Literal["u", "v", "radius"]
    channel: Literal["red", "green", "blue", "luminance"]
    unit: str
    positions_m: tuple[float, ...]
    curves: tuple[Curve, ...]


class PatchRecord(Record):
    """The measured rectangle in the world, and its outline in the image (pixels, row 0 on top)."""

    center: tuple[float, float, float]
    u: tuple[float, float, float]
    v: tuple[float, float, float]
    outline_px: tuple[tuple[float, float], ...] = ()
    coverage: float = Field(default=1.0, ge=0, le=1)


class AblationOutcome(StrEnum):
    """What became of a deviation when something was switched off in both engines."""

    GOES = "goes"
    STAYS = "stays"
    UNCLEAR = "unclear"
    NOT_RENDERED = "not_rendered"


class AblationEntry(Record):
    """One thing switched off: how, and the number that tells what became of the deviation, before and after.

    ``before`` and ``after`` are differences from the ideal in ``unit``, ``interval`` that of ``after``; without a
    number ``reason`` says why there is none. ``absent`` phenomena are surely off, ``touched`` ones may have changed.
    """

    off: str
    words: str
    outcome: AblationOutcome
    metric: str = ""
    unit: str = ""
    before: float | None = None
    after: float | None = None
    interval: Interval | None = None
    reason: str = ""
    absent: tuple[Phenomenon, ...]
    touched: tuple[Phenomenon, ...]


class LayerShare(Record):
    """What one of the tracer's layers gives to the light of a patch, in the channel in which the engines differ most.

    ``acts_on`` is the share of the light that the phenomenon may change: a caustic only its own layer, but bending and
    mirroring all that came by glass or mirror. ``needed``: by what share of that it would have to be wrong to make the
    deviation; null where the tracer's mean light does not exceed POV-Ray's. What POV-Ray lacks altogether is wrong by
    1; above that there is too little light.
    """

    layer: Phenomenon
    channel: Literal["red", "green", "blue"]
    share: float
    acts_on: float
    needed: float | None = None


class Whereabouts(Record):
    """Where a deviation between the engines lives: the ``suspects`` that all evidence leaves, and the evidence.

    One fault is supposed. One suspect is a name, several were not told apart, none means that no single phenomenon
    explains what was seen. Closed forms say which engine is wrong; this never does.
    """

    suspects: tuple[Phenomenon, ...]
    reason: str
    ablations: tuple[AblationEntry, ...] = ()
    layers: tuple[LayerShare, ...] = ()


class ObservationResult(Record):
    """One phenomenon on one patch: everything that was measured and what it came to.

    ``unmeasured`` says which numbers could not be had and why; with any of them the verdict is not ``agrees``. ``view``
    is the picture in which it was measured, null for the scene's own; ``noise`` is what its noise comes from. ``where``
    is looked for only when the engines deviate from each other. ``statement`` says how close its numbers are known to
    be; ``bound`` is that of the number which is most tolerances wide.
    """

    name: str
    phenomenon: Phenomenon
    patch: PatchRecord
    view: ViewRecord | None = None
    noise: tuple[NoiseRecord, ...] = ()
    comparisons: tuple[Comparison, ...]
    profiles: tuple[Profile, ...] = ()
    unmeasured: tuple[str, ...] = ()
    verdict: Verdict
    bound: Bound | None = None
    statement: str = ""
    attribution: Attribution | None = None
    where: Whereabouts | None = None
