"""Judge what was observed: every number with its tolerance at the run's level, every observation with its cause."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import number_in
from vitrail.judge.attribution import attribute, headline
from vitrail.judge.bound import worst
from vitrail.judge.comparison import Comparison, ObservationResult, TolerancePart, Verdict
from vitrail.judge.observe import Observed
from vitrail.judge.references import Truth
from vitrail.judge.rules import Rule
from vitrail.judge.statements import observation_statement
from vitrail.judge.thresholds import Thresholds
from vitrail.judge.verdict import Measured, decide, overall

Residual = Callable[[Phenomenon, float], float]
"""The certificate's relative bound for a phenomenon; the number says how much larger the whole is than the light."""


def judge_observation(
    observed: Observed, thresholds: Thresholds, residual: Residual, level: float
) -> ObservationResult:
    """The verdict of one observation.

    An observation that could not be measured in part is at best inconclusive: what is missing has not agreed.
    """
    phenomenon = observed.observation.phenomenon
    comparisons = attribute(
        [
            _judge(entry, truth, observed, thresholds.rule(phenomenon, entry.metric), residual, level)
            for entry, truth in zip(observed.measured, observed.truths, strict=True)
        ]
    )
    verdict = overall(entry.verdict for entry in comparisons) or Verdict.INCONCLUSIVE
    if observed.unmeasured and verdict is Verdict.AGREES:
        verdict = Verdict.INCONCLUSIVE
    return ObservationResult(
        name=observed.observation.name,
        phenomenon=phenomenon,
        patch=observed.patch,
        view=observed.view,
        noise=observed.noise,
        comparisons=comparisons,
        profiles=observed.profiles,
        unmeasured=observed.unmeasured,
        verdict=verdict,
        bound=worst(comparisons),
        statement=observation_statement(phenomenon, comparisons, observed.unmeasured),
        attribution=headline(comparisons, verdict),
    )


def _judge(
    measured: Measured, truth: Truth | None, observed: Observed, rule: Rule, residual: Residual, level: float
) -> Comparison:
    """One number: its own threshold or its formula's tolerance, widened by the certificate where POV-Ray takes part."""
    own = truth.tolerance(measured.pair.candidate) if truth is not None else None
    parts: Sequence[TolerancePart] = [own or rule.part(measured.ideal, observed.half_edge_m)]
    is_translated = "povray" in (measured.pair.candidate, measured.pair.reference)
    # Rounding of the whole weighs more in a share of it; it does not move light from place to place.
    whole_over_light = number_in(measured.settings, "whole_over_light", 1.0) if rule.kind == "relative" else 1.0
    stated = residual(observed.observation.phenomenon, whole_over_light)
    widening = rule.widening(stated, measured.ideal, observed.half_edge_m) if is_translated else 0.0
    if widening > 0:
        phenomenon = observed.observation.phenomenon.value
        reason = f"the certificate states {stated:.2g} for {phenomenon}"
        parts = [*parts, TolerancePart(source="certificate", amount=widening, reason=reason)]
    lost = observed.lost.parts(rule, measured.ideal, observed.half_edge_m, is_translated=is_translated)
    parts = [*parts, *(each for each in lost if each.amount > 0)]
    if measured.smoothing > 0:
        reason = "smoothed once more by its gather disc, pixels and cells, it changes so much"
        parts = [*parts, TolerancePart(source="resolution", amount=measured.smoothing, reason=reason)]
    return decide(measured, parts, level)
