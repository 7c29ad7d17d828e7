"""Why two results differ, and against a closed form: who is wrong.

Four causes, told apart by evidence that is already in the comparison:
*translation*: the difference is larger than the metric's own threshold, but inside what the certificate states;
*noise*: the interval is wider than the tolerance, so the numbers cannot tell;
*numerics*: what is left over the tolerance is within the rounding of POV-Ray's half floats;
*model*: everything else: one of the two computes another physics, or has a defect.
"""

from __future__ import annotations

from collections.abc import Sequence

from vitrail.base.changed import changed
from vitrail.judge.comparison import Attribution, Cause, Comparison, Pair, Verdict, maker

HALF_FLOAT_STEP = 2.0**-11
"""Largest relative rounding error of a half float, in which POV-Ray writes [P 6]."""

ROUNDINGS = 4
"""A metric divides, sums or subtracts a few rounded numbers; four of them at their worst in one direction."""


TRANSLATED = ("certificate", "dropped")
"""Parts of a tolerance that are there because POV-Ray does something else."""


def attribute(comparisons: Sequence[Comparison]) -> tuple[Comparison, ...]:
    """The comparisons of one observation, each that needs one with its cause."""
    return tuple(
        comparison if cause is None else changed(comparison, attribution=cause)
        for comparison in comparisons
        for cause in [_cause(comparison, comparisons)]
    )


def headline(comparisons: Sequence[Comparison], verdict: Verdict) -> Attribution | None:
    """The attribution of a whole observation: that of its verdict, the one that names an engine first."""
    found = [entry.attribution for entry in comparisons if entry.verdict is verdict and entry.attribution is not None]
    if not found:
        return None
    order = (Cause.MODEL, Cause.NUMERICS, Cause.TRANSLATION, Cause.NOISE)
    return min(found, key=lambda each: (order.index(each.cause), each.engine is None))


def _cause(comparison: Comparison, family: Sequence[Comparison]) -> Attribution | None:
    """The cause of one comparison; None where it agrees on the metric's own threshold."""
    match comparison.verdict:
        case Verdict.AGREES:
            return _explained(comparison)
        case Verdict.INCONCLUSIVE:
            half = comparison.interval.half_width
            reason = f"the interval is ±{half:.3g} wide, the tolerance ±{comparison.tolerance:.3g}"
            return Attribution(cause=Cause.NOISE, reason=reason)
        case Verdict.DEVIATES:
            return _deviation(comparison, family)


def _explained(comparison: Comparison) -> Attribution | None:
    """Agreement that needed the certificate is a difference explained by translation."""
    own = sum(part.amount for part in comparison.tolerance_parts if part.source not in TRANSLATED)
    if abs(comparison.difference) <= own or own == comparison.tolerance:
        return None
    stated = comparison.tolerance - own
    reason = (
        f"the difference exceeds the threshold of {own:.3g} and is inside the {stated:.3g} that the translation states"
    )
    return Attribution(cause=Cause.TRANSLATION, engine="povray", reason=reason)


def _deviation(comparison: Comparison, family: Sequence[Comparison]) -> Attribution:
    """Rounding, or else a model; with a closed form on either side it has a name."""
    excess = abs(comparison.difference) - comparison.tolerance
    rounding = ROUNDINGS * HALF_FLOAT_STEP * max(abs(comparison.ideal), abs(comparison.value))
    if "povray" in (comparison.pair.candidate, comparison.pair.reference) and 0 <= excess <= rounding:
        reason = f"the {excess:.2g} over the tolerance is what rounding to half floats can do ({rounding:.2g})"
        return Attribution(cause=Cause.NUMERICS, engine="povray", reason=reason)
    engine, evidence = _guilty(comparison.pair, family)
    return Attribution(cause=Cause.MODEL, engine=engine, reason=evidence)


def _guilty(pair: Pair, family: Sequence[Comparison]) -> tuple[str | None, str]:
    """Who is wrong, judged by the closed forms of the same observation."""
    if pair.reference == "truth":
        return pair.candidate, "it is held against a closed form, outside the tolerance"
    if pair.reference == "stored":
        return pair.candidate, "it no longer gives what was accepted as the reference"
    truth = {
        side: {entry.verdict for entry in family if entry.pair.candidate == side and entry.pair.reference == "truth"}
        for side in (pair.candidate, pair.reference)
    }
    wrong = [side for side, verdicts in truth.items() if Verdict.DEVIATES in verdicts]
    right = [side for side, verdicts in truth.items() if verdicts == {Verdict.AGREES}]
    if len(wrong) == 1 and right:
        return wrong[0], f"{maker(right[0])} agrees with the closed forms and {maker(wrong[0])} does not"
    if len(wrong) == 1:
        other = pair.reference if wrong[0] == pair.candidate else pair.candidate
        return wrong[0], f"{maker(wrong[0])} deviates from a closed form; {maker(other)} has none to be held against"
    if len(wrong) == 2:
        return None, "both deviate from the closed forms"
    if right:
        return None, "the closed forms of this observation do not see the difference"
    return None, "no closed form is known here, so neither engine is shown to be wrong"
