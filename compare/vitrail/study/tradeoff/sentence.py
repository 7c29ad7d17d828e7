"""What accuracy costs, in one plain sentence."""

from __future__ import annotations

from collections.abc import Mapping

from vitrail.base.engine_name import EngineName
from vitrail.study.tradeoff.records import Price

NAMES: dict[EngineName, str] = {EngineName.TRACER: "the tracer", EngineName.POVRAY: "POV-Ray"}


def sentence(
    phenomenon: str,
    prices: Mapping[EngineName, Mapping[str, Price]],
    targets: tuple[float, ...],
    own_error: float | None,
) -> str:
    """What each target costs in each engine; *at most* where the cheapest setting tried is good enough already.

    ``prices`` are by engine and by target, as in ``EngineFront.price_s``.
    ``own_error`` is that of the converged reference, None where a closed form is the truth.
    """
    errors = _listed([f"{100 * target:g} %" for target in targets])
    parts = [
        f"{NAMES[engine]} {_listed([price_in_words(prices[engine][str(target)]) for target in targets])}"
        for engine in NAMES
        if engine in prices
    ]
    against = "" if own_error is None else f", against a rendering that is itself known to {_percent(own_error)}"
    return f"An error of {errors} in the {phenomenon.replace('_', ' ')} costs {'; '.join(parts)}{against}."


def _listed(parts: list[str]) -> str:
    """``a, b and c``; once where all are the same."""
    if len(parts) > 1 and len(set(parts)) == 1:
        return f"{parts[0]} at all" if parts[0].startswith("not") else f"{parts[0]} each"
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def price_in_words(price: Price) -> str:
    """``0.17 CPU s``, *at most* where the cheapest setting tried is good enough already, or why there is no price."""
    if price.status == "below_reference":
        return "not known"
    if price.cpu_s is None:
        return "not reached"
    return f"{'at most ' if price.status == 'at_most' else ''}{seconds(price.cpu_s)}"


def seconds(value: float) -> str:
    return f"{value:.2g} CPU s" if value < 10 else f"{value:.0f} CPU s"


def _percent(error: float) -> str:
    return f"{100 * error:.2g} %"
