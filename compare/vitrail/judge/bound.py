"""How close a number is known to be, whatever its verdict: the bound comes first, the verdict second.

The bound of a comparison is the largest difference that its interval holds. Words for people take the interval at 95 %,
which is what *known to within* means elsewhere; a verdict takes the stricter level of the whole run, and so does
``over_tolerance``, which is 1 or less exactly where the number agrees.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from vitrail.judge.comparison import Bound, Comparison, Interval, Verdict
from vitrail.metrics.plain_names import in_words

LEVEL = 0.95
"""The confidence of a bound that is told to people."""


def reach(interval: Interval) -> float:
    """The largest difference, of either sign, that an interval holds."""
    return max(abs(interval.low), abs(interval.high))


def bound_of(metric: str, ideal: float, told: Interval, judged: Interval, tolerance: float) -> Bound:
    """The bound of one number: ``told`` is its interval at the level for people, ``judged`` that of its verdict."""
    amount = reach(told)
    return Bound(
        amount=amount,
        level=told.level,
        words=in_words(metric, amount, ideal),
        over_tolerance=reach(judged) / tolerance if tolerance > 0 else None,
    )


def worst(comparisons: Iterable[Comparison]) -> Bound | None:
    """The bound that is most tolerances wide; one without a tolerance is wider than all unless it is 0."""
    bounds = [entry.bound for entry in comparisons if entry.bound is not None]
    return max(bounds, key=_width, default=None)


def number_statement(
    metric: str, ideal: float, difference: float, tolerance: float, bound: Bound, verdict: Verdict, judged: Interval
) -> str:
    """One number in words: ``agrees to within 0.41 % (95 %; tolerance 0.35 % not yet shown at 99.99 %)``."""
    allowed, level = in_words(metric, tolerance, ideal, up=False), percent(bound.level)
    match verdict:
        case Verdict.AGREES:
            return f"agrees to within {bound.words} ({level})"
        case Verdict.INCONCLUSIVE:
            shown = f"tolerance {allowed} not yet shown at {percent(judged.level)}"
            return f"agrees to within {bound.words} ({level}; {shown})"
        case Verdict.DEVIATES:
            return f"deviates by {in_words(metric, abs(difference), ideal, up=False)} (tolerance {allowed})"


def percent(level: float) -> str:
    """A level of confidence in a sentence, with two digits of what is missing to certainty: 95 %, 99.961 %."""
    decimals = max(0, math.ceil(-math.log10(100 * (1 - level))) + 1)
    text = f"{100 * level:.{decimals}f}"
    return f"{text.rstrip('0').rstrip('.') if '.' in text else text} %"


def _width(bound: Bound) -> float:
    if bound.over_tolerance is not None:
        return bound.over_tolerance
    return math.inf if bound.amount > 0 else 0.0
