"""Where a deviation between the engines lives: what becomes of it when one thing after the other is switched off.

Each ablation is judged by the numbers that deviated. The deviation *goes* when all of them agree and the furthest one
is surely less than half of what it was; it *stays* when that one still deviates to the same side by half of what it was
or more; all else is *unclear* and counts for nothing. One fault supposed, a deviation that goes is one of what the
ablation touched, and one that stays is none of what it took away. What is left are the suspects.

The tracer's layers are the second evidence: what gives a hundredth of the light cannot make a tenth of excess.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vitrail.base.changed import changed
from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import (
    AblationEntry,
    AblationOutcome,
    Comparison,
    Interval,
    LayerShare,
    ObservationResult,
    Pair,
    Verdict,
    Whereabouts,
)
from vitrail.judge.patch_light import PatchLight, is_too_weak, layer_shares
from vitrail.judge.where_words import sentence
from vitrail.metrics.measurement import CHANNELS

HALF = 0.5
"""The middle between a deviation that is still there and none; noise must not reach it from either side."""

DARK = 0.1
"""With less than a tenth of its light left a patch agrees for want of light."""

LIGHT_FAMILIES = ("radiance_ratio", "flux_ratio")
"""The numbers that compare the mean light of two patches."""


@dataclass(frozen=True)
class Switched:
    """One ablation of one observation: what it does, and what came of it. Without ``after`` nothing was rendered.

    ``darkens``: a dark patch is what the ablation is for, and tells as much as a bright one.
    """

    off: str
    words: str
    absent: frozenset[Phenomenon]
    touched: frozenset[Phenomenon]
    darkens: bool
    after: ObservationResult | None = None
    light: PatchLight | None = None
    reason: str = ""


def whereabouts(
    before: ObservationResult,
    light: PatchLight,
    switched: Sequence[Switched],
    required: frozenset[Phenomenon],
    level: float,
) -> Whereabouts | None:
    """The suspects and the evidence; None where the engines do not deviate from each other."""
    deviating = _furthest_first(before)
    if not deviating:
        return None
    entries = tuple(_entry(deviating, before.phenomenon, light, each, level) for each in switched)
    is_about_light = any(each.metric.split(".")[0] in LIGHT_FAMILIES for each in deviating)
    layers = layer_shares(light, level, mean_deviates=is_about_light)
    suspects = _suspects(entries, layers, required | {Phenomenon.DIFFUSION})
    ordered = tuple(each for each in Phenomenon if each in suspects)
    return Whereabouts(
        suspects=ordered, reason=sentence(ordered, entries, layers, required), ablations=entries, layers=layers
    )


def _furthest_first(observation: ObservationResult) -> list[Comparison]:
    """What deviates between the engines, the most tolerances off first."""
    found = [
        entry
        for entry in observation.comparisons
        if entry.pair is Pair.TRACER_POVRAY and entry.verdict is Verdict.DEVIATES
    ]
    return sorted(found, key=lambda entry: -abs(entry.difference) / max(entry.tolerance, 1e-300))


def _suspects(
    entries: Sequence[AblationEntry], layers: Sequence[LayerShare], every: frozenset[Phenomenon]
) -> frozenset[Phenomenon]:
    """What all the evidence leaves; layers may only take away what is not the last suspect."""
    left = every
    for entry in entries:
        match entry.outcome:
            case AblationOutcome.GOES:
                left &= frozenset(entry.touched)
            case AblationOutcome.STAYS:
                left -= frozenset(entry.absent)
            case AblationOutcome.UNCLEAR | AblationOutcome.NOT_RENDERED:
                pass
    strong = left - {each.layer for each in layers if is_too_weak(each)}
    return strong or left


def _entry(
    deviating: Sequence[Comparison], observed: Phenomenon, light: PatchLight, switched: Switched, level: float
) -> AblationEntry:
    """What became of the deviation, with the number that tells."""
    base = AblationEntry(
        off=switched.off,
        words=switched.words,
        outcome=AblationOutcome.NOT_RENDERED,
        reason=switched.reason,
        absent=tuple(each for each in Phenomenon if each in switched.absent),
        touched=tuple(each for each in Phenomenon if each in switched.touched),
    )
    if switched.after is None or switched.light is None:
        return base
    after = {entry.metric: entry for entry in switched.after.comparisons if entry.pair is Pair.TRACER_POVRAY}
    measured = [(old, after[old.metric]) for old in deviating if old.metric in after]
    of_light = [pair for pair in measured if pair[0].metric.split(".")[0] in LIGHT_FAMILIES]
    if measured:
        found = changed(base, **_by_numbers(measured))
        # With the observed phenomenon off, its numbers may be of nothing; its light or the furthest still tell.
        for fewer in (of_light, measured[:1]) if switched.off == observed.value else ():
            if fewer and found.outcome is AblationOutcome.UNCLEAR:
                found = changed(base, **_by_numbers(fewer))
    elif switched.off == observed.value and after and all(e.verdict is Verdict.AGREES for e in after.values()):
        reason = "there is nothing left of it to measure, and all that can still be measured agrees"
        found = changed(base, outcome=AblationOutcome.GOES, reason=reason)
    else:
        found = changed(base, **_by_light(light, switched.light, level))
    is_dark = switched.light.brightest < DARK * light.brightest
    if found.outcome is AblationOutcome.GOES and is_dark and not switched.darkens:
        return changed(found, outcome=AblationOutcome.UNCLEAR, reason="the patch is dark then")
    return found


def _by_numbers(measured: Sequence[tuple[Comparison, Comparison]]) -> dict[str, object]:
    """By the deviating numbers that can still be measured; the furthest one tells."""
    old, new = measured[0]
    agree = all(each.verdict is Verdict.AGREES for _, each in measured)
    outcome, reason = _outcome(old.difference, new.interval, stays=new.verdict is Verdict.DEVIATES, goes=agree)
    numbers = {"metric": new.metric, "unit": new.unit, "before": old.difference, "after": new.difference}
    return {**numbers, "interval": new.interval, "outcome": outcome, "reason": reason}


def _by_light(before: PatchLight, after: PatchLight, level: float) -> dict[str, object]:
    """By the mean light of the patch, where nothing of what deviated can be measured any more."""
    channel = before.worst
    known, new = before.difference(channel, level), after.difference(channel, level)
    if known is None or new is None or known.low <= 0 <= known.high:
        reason = "nothing that deviated can be measured then, and the mean light did not deviate"
        return {"outcome": AblationOutcome.UNCLEAR, "reason": reason}
    old = float(before.tracer[channel] - before.povray[channel])
    interval = Interval(low=new.low, high=new.high, level=level, method=new.method)
    outcome, reason = _outcome(old, interval, stays=True, goes=True)
    numbers = {"metric": f"mean_difference.{CHANNELS[channel]}", "unit": "W sr^-1 m^-2", "before": old}
    after_difference = float(after.tracer[channel] - after.povray[channel])
    return {**numbers, "after": after_difference, "interval": interval, "outcome": outcome, "reason": reason}


def _outcome(old: float, new: Interval, *, stays: bool, goes: bool) -> tuple[AblationOutcome, str]:
    """Where the whole interval lies against half of what the difference was, and on which side."""
    shares = sorted((new.low / old, new.high / old))
    if goes and max(abs(share) for share in shares) <= HALF:
        return AblationOutcome.GOES, ""
    if stays and shares[0] >= HALF:
        return AblationOutcome.STAYS, ""
    return AblationOutcome.UNCLEAR, "what is left is neither none of it nor all of it"
