"""One comparison in a sentence: how close, the numbers, why, and what would decide it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from vitrail.judge.comparison import maker

if TYPE_CHECKING:
    from vitrail.judge.comparison import Comparison, ObservationResult

AFFORDABLE = 1e4
"""Times the samples beyond which nobody will wait."""


def sentence(observation: ObservationResult, comparison: Comparison) -> str:
    """For a terminal, an annotation or a test's message; no markup."""
    interval, unit = comparison.interval, _unit(comparison.unit)
    text = (
        f"{observation.phenomenon.value}: {comparison.pair.value} {comparison.metric} {comparison.statement}; "
        f"it is {comparison.value:.5g}{unit}, should be {comparison.ideal:.5g} +- {comparison.tolerance:.3g}; "
        f"the difference lies in [{interval.low:.3g}, {interval.high:.3g}]"
    )
    cause = comparison.attribution
    because = (
        f" ({cause.cause.value}{f' of {maker(cause.engine)}' if cause.engine else ''}: {cause.reason})" if cause else ""
    )
    return text + because + _remedy(comparison.sample_factor)


def where(observation: ObservationResult) -> list[str]:
    """The line that says where a deviation between the engines lives; none where nobody looked."""
    return [] if observation.where is None else [f"where: {observation.where.reason}"]


def _remedy(factor: float | None) -> str:
    """What an undecided comparison wants."""
    if factor is None:
        return ""
    if factor > AFFORDABLE:
        return "; no affordable number of samples would decide: choose a patch with more light"
    return f"; {factor:.{0 if factor >= 10 else 1}f} times the samples would decide"


def _unit(unit: str) -> str:
    return "" if unit in ("", "1") else f" {unit}"
