"""From a measured number, its noise and its tolerance to one of three words, and from many words to one.

The test is one of equivalence: a comparison *agrees* only if the whole interval of its difference lies inside the
tolerance, *deviates* only if the whole interval lies outside, and is *inconclusive* while the interval straddles an
edge. Noise thus can never turn into agreement, and a wide tolerance is never needed to keep a noisy test quiet.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from pydantic import JsonValue
from scipy.special import stdtrit

from vitrail.judge.bound import LEVEL, bound_of, number_statement
from vitrail.judge.comparison import Comparison, Interval, Pair, TolerancePart, Verdict


@dataclass(frozen=True)
class Noise:
    """The random error of a measured value: its standard error and how many degrees of freedom that was taken from.

    ``standard_error`` 0 means the value has no random error (two runs give the same bits).
    """

    standard_error: float
    degrees_of_freedom: float = math.inf
    method: str = "exact"


@dataclass(frozen=True)
class Measured:
    """A value that still waits for its verdict, because the level of its interval depends on the whole suite.

    ``smoothing`` is what the resolution of the image does to the value, in its unit: its gather disc, pixels and
    cells; 0 where both sides have the same.
    """

    pair: Pair
    metric: str
    unit: str
    value: float
    ideal: float
    noise: Noise
    ideal_source: str = ""
    settings: dict[str, JsonValue] = field(default_factory=dict)
    parts: dict[str, JsonValue] = field(default_factory=dict)
    caveats: tuple[str, ...] = ()
    smoothing: float = 0.0


def interval_of(measured: Measured, level: float) -> Interval:
    """The two-sided Student interval of ``value - ideal`` at ``level``; exact values have one of no width."""
    noise, difference = measured.noise, measured.value - measured.ideal
    if noise.standard_error == 0:
        return Interval(low=difference, high=difference, level=level, method="exact")
    quantile = -float(stdtrit(noise.degrees_of_freedom, (1 - level) / 2))
    reach = quantile * noise.standard_error
    return Interval(low=difference - reach, high=difference + reach, level=level, method=noise.method)


def decide(measured: Measured, tolerance_parts: Sequence[TolerancePart], level: float) -> Comparison:
    """Judge one measured value; ``level`` is the corrected level of the suite."""
    interval = interval_of(measured, level)
    tolerance, difference = sum(part.amount for part in tolerance_parts), measured.value - measured.ideal
    verdict = _position(interval, tolerance)
    bound = bound_of(measured.metric, measured.ideal, interval_of(measured, LEVEL), interval, tolerance)
    factor = _sample_factor(interval, tolerance) if verdict is Verdict.INCONCLUSIVE else None
    return Comparison(
        pair=measured.pair,
        metric=measured.metric,
        unit=measured.unit,
        value=measured.value,
        ideal=measured.ideal,
        ideal_source=measured.ideal_source,
        difference=difference,
        interval=interval,
        tolerance=tolerance,
        tolerance_parts=tuple(tolerance_parts),
        verdict=verdict,
        bound=bound,
        statement=number_statement(measured.metric, measured.ideal, difference, tolerance, bound, verdict, interval),
        sample_factor=factor,
        reason=_sentence(interval, tolerance, verdict, factor),
        settings=measured.settings,
        parts=measured.parts,
        caveats=measured.caveats,
    )


def _position(interval: Interval, tolerance: float) -> Verdict:
    """Where the interval of the difference lies against [-tolerance, tolerance]."""
    if -tolerance <= interval.low and interval.high <= tolerance:
        return Verdict.AGREES
    if interval.low > tolerance or interval.high < -tolerance:
        return Verdict.DEVIATES
    return Verdict.INCONCLUSIVE


def _sample_factor(interval: Interval, tolerance: float) -> float | None:
    """How many times the samples would bring the interval to one side, if its middle stays where it is.

    The half width falls with the square root of the samples. None where the middle lies on the edge itself.
    """
    middle = (interval.low + interval.high) / 2
    room = abs(abs(middle) - tolerance)
    if room <= 1e-12 * max(abs(middle), tolerance):
        return None
    return max((interval.half_width / room) ** 2, 1.0)


def _sentence(interval: Interval, tolerance: float, verdict: Verdict, factor: float | None) -> str:
    """Say the verdict with its numbers."""
    span = f"[{interval.low:.4g}, {interval.high:.4g}]"
    match verdict:
        case Verdict.AGREES:
            return f"the interval {span} of the difference lies inside ±{tolerance:.4g}"
        case Verdict.DEVIATES:
            return f"the interval {span} of the difference lies wholly outside ±{tolerance:.4g}"
        case Verdict.INCONCLUSIVE:
            more = (
                f"about {math.ceil(factor)} times the samples would decide"
                if factor
                else "no number of samples decides"
            )
            return f"the interval {span} of the difference crosses the edge of ±{tolerance:.4g}; {more}"


def overall(verdicts: Iterable[Verdict | None]) -> Verdict | None:
    """The word for many: one deviation outweighs every doubt, one doubt every agreement; None: nothing judged."""
    words = {verdict for verdict in verdicts if verdict is not None}
    for word in (Verdict.DEVIATES, Verdict.INCONCLUSIVE, Verdict.AGREES):
        if word in words:
            return word
    return None
