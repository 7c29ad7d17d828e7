"""How close things are, in sentences: what a user reads before any verdict.

*The caustic agrees to within 1.0 %, its place to 0.6 mm (95 %).* Each aspect of an observation speaks by its widest
number. What is open is said to agree as far as it is known, with the tolerance that is not shown yet.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.bound import LEVEL, percent
from vitrail.judge.comparison import Comparison, ObservationResult, Pair, Verdict, maker
from vitrail.judge.scan_records import ScanResult
from vitrail.metrics.plain_names import SUBJECTS, Measure, in_words, plain_name

MOST_PHENOMENA = 3
"""Phenomena that one line about a scene tells; the widest come first."""

_SEVERITY = (Verdict.AGREES, Verdict.INCONCLUSIVE, Verdict.DEVIATES)
_OTHER_SIDE = {"truth": "the closed form", "stored": "the stored image"}


def observation_statement(
    phenomenon: Phenomenon, comparisons: Sequence[Comparison], unmeasured: Sequence[str] = ()
) -> str:
    """One observation: first the pair that matters most in full, then the others by their light."""
    pairs = [pair for pair in Pair if any(entry.pair is pair for entry in comparisons)]
    told, agreed_with = [], ""
    for pair in pairs:
        mine, is_first = [entry for entry in comparisons if entry.pair is pair], pair is pairs[0]
        subject = _subject(phenomenon, pair) if is_first else maker(pair.candidate)
        aspects = _aspects(mine, with_agreeing=is_first)
        told.append(_clause(subject, pair, aspects, goes_on=pair.reference == agreed_with))
        agreed_with = "" if any(entry.verdict is Verdict.DEVIATES for entry in aspects) else pair.reference
    if unmeasured:
        told.append(f"{len(unmeasured)} of its numbers could not be measured")
    return _sentence(told, has_bound=bool(pairs))


def scene_statement(observations: Sequence[ObservationResult], scan: ScanResult | None = None) -> str:
    """A scene in one line: each phenomenon by its widest numbers, then what the scan found to deviate elsewhere."""
    beside = [place.words for place in scan.places if place.deviates] if scan is not None else []
    more = f" {beside[0][:1].upper()}{beside[0][1:]}." if beside else ""
    return _observed_statement(observations) + more


def _observed_statement(observations: Sequence[ObservationResult]) -> str:
    """Each phenomenon by its widest numbers, the widest phenomenon first."""
    entries = [entry for observation in observations for entry in observation.comparisons]
    first = next((pair for pair in Pair if any(entry.pair is pair for entry in entries)), None)
    if len(observations) == 1 or first is None:
        return observations[0].statement if observations else ""
    found = [(phenomenon, _of(observations, phenomenon)) for phenomenon in Phenomenon]
    ranked = sorted(((p, mine) for p, mine in found if mine), key=lambda each: _rank(each[1]), reverse=True)
    told = []
    for phenomenon, mine in ranked[:MOST_PHENOMENA]:
        pair = next(pair for pair in Pair if any(entry.pair is pair for entry in mine))
        told.append(_clause(_subject(phenomenon, pair), pair, _aspects([e for e in mine if e.pair is pair])))
    rest = [SUBJECTS[phenomenon] for phenomenon, _ in ranked[MOST_PHENOMENA:]]
    return _sentence([*told, *([f"known more closely: {', '.join(rest)}"] if rest else [])], has_bound=True)


def scene_headline(observations: Sequence[ObservationResult], scan: ScanResult | None = None) -> str:
    """The widest part of a scene's statement, for a line of a terminal: one phenomenon, one pair.

    A deviation comes before a doubt, a doubt before agreement; among equals the engines before closed forms.
    """
    groups = [
        (phenomenon, pair, mine)
        for phenomenon in Phenomenon
        for pair in Pair
        if (mine := [entry for entry in _of(observations, phenomenon) if entry.pair is pair])
    ]
    beside = [place.words for place in scan.places if place.deviates] if scan is not None else []
    if not groups or beside:
        return beside[0] if beside else ""
    order = list(Pair)
    phenomenon, pair, mine = max(groups, key=lambda each: (_rank(each[2])[0], -order.index(each[1]), _rank(each[2])))
    return _sentence([_clause(_subject(phenomenon, pair), pair, _aspects(mine))], has_bound=True)


def run_statement(counts: dict[str, int]) -> str:
    """A run in one sentence: how many scenes agree, deviate, are not shown to agree closely enough, failed."""
    scenes = sum(counts.values())
    words = (
        ("agrees", "agrees", "agree", ""),
        ("deviates", "deviates", "deviate", ""),
        ("inconclusive", "agrees", "agree", " as far as is known, within a bound wider than the tolerance"),
        ("unjudged", "was", "were", " not judged"),
    )
    told = [
        (counts[key], f"{one if counts[key] == 1 else many}{rest}") for key, one, many, rest in words if counts.get(key)
    ]
    if not told:
        return "There is no scene."
    (count, first), *others = told
    total = f"{count} of {scenes} scenes" if scenes != 1 else "The scene"
    return "; ".join([f"{total} {first}", *(f"{number} {text}" for number, text in others)]) + "."


# --- clauses --------------------------------------------------------------------------------------------------------


def _of(observations: Iterable[ObservationResult], phenomenon: Phenomenon) -> list[Comparison]:
    return [entry for each in observations if each.phenomenon is phenomenon for entry in each.comparisons]


def _rank(comparisons: Sequence[Comparison]) -> tuple[int, float]:
    """Deviations before doubts before agreement, each by its widest bound."""
    return max((_SEVERITY.index(entry.verdict), _over_tolerance(entry)) for entry in comparisons)


def _over_tolerance(entry: Comparison) -> float:
    return entry.bound.over_tolerance or 0.0 if entry.bound is not None else 0.0


def _subject(phenomenon: Phenomenon, pair: Pair) -> str:
    """What the first clause is about; against a closed form or a stored image also whose picture it is."""
    name = SUBJECTS[phenomenon]
    return f"{name} of {maker(pair.candidate)}" if pair.reference in _OTHER_SIDE else name


def _aspects(comparisons: Sequence[Comparison], *, with_agreeing: bool = True) -> list[Comparison]:
    """One number for each aspect that is told: its worst, and among equals the widest; the light first."""
    ordered = sorted(comparisons, key=lambda entry: plain_name(entry.metric).aspect)
    found = [max(each, key=_widest) for _, each in groupby(ordered, lambda entry: plain_name(entry.metric).aspect)]
    place = {entry.metric: index for index, entry in reversed(list(enumerate(comparisons)))}
    found.sort(key=lambda entry: (plain_name(entry.metric).aspect != "", place[entry.metric]))
    told = [entry for entry in found if plain_name(entry.metric).leading or entry.verdict is not Verdict.AGREES]
    first = (told or found)[:1]
    return first + [e for e in told[1:] if with_agreeing or e.verdict is not Verdict.AGREES]


def _widest(entry: Comparison) -> tuple[int, float]:
    amount = entry.bound.amount if entry.bound is not None else 0.0
    is_relative = plain_name(entry.metric).measure is Measure.OF_IDEAL and entry.ideal != 0
    return _SEVERITY.index(entry.verdict), amount / abs(entry.ideal) if is_relative else amount


def _clause(subject: str, pair: Pair, aspects: Sequence[Comparison], *, goes_on: bool = False) -> str:
    """``the caustic agrees to within 1.0 %, its place to 0.6 mm``; each deviation is said as one.

    ``goes_on`` leaves out the verb where the clause before has said it: ``POV-Ray to within 0.3 %``.
    """
    other = _OTHER_SIDE.get(pair.reference, "")
    equal, unequal = (f" with {other}", f" from {other}") if other else ("", "")
    told, agreed = [], False
    for index, entry in enumerate(aspects):
        aspect = plain_name(entry.metric).aspect
        noun = subject if index == 0 else f"its {aspect}"
        inside = f" in {aspect}" if index == 0 and aspect else ""
        if entry.verdict is Verdict.DEVIATES:
            amount = in_words(entry.metric, abs(entry.difference), entry.ideal, up=False)
            told.append(
                f"{noun} deviates{unequal if index == 0 else ''} by {amount}{inside} (tolerance {_tolerance(entry)})"
            )
        else:
            bound = entry.bound.words if entry.bound is not None else "an unknown bound"
            verb = "to" if agreed else "to within" if goes_on and index == 0 else f"agrees{equal} to within"
            told.append(f"{noun} {verb} {bound}{inside}{_open(entry)}")
        agreed = entry.verdict is not Verdict.DEVIATES
    return ", ".join(told)


def _tolerance(entry: Comparison) -> str:
    return in_words(entry.metric, entry.tolerance, entry.ideal, up=False)


def _open(entry: Comparison) -> str:
    if entry.verdict is not Verdict.INCONCLUSIVE:
        return ""
    # At 95 % it may be shown already: the verdict asks for more.
    is_shown_to_people = entry.bound is not None and entry.bound.amount <= entry.tolerance
    level = " at the run's level" if is_shown_to_people else ""
    return f" (tolerance {_tolerance(entry)} not yet shown{level})"


def _sentence(clauses: Sequence[str], *, has_bound: bool) -> str:
    text = "; ".join(clauses)
    level = f" ({percent(LEVEL)})" if has_bound else ""
    return f"{text[:1].upper()}{text[1:]}{level}."
