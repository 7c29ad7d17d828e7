"""What accuracy costs, in one plain sentence."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

NAMES = {"tracer": "the tracer", "povray": "POV-Ray"}


def sentence(phenomenon: str, engines: Mapping[str, Any], targets: tuple[float, ...], own_error: float | None) -> str:
    """What each target costs in each engine; *at most* where the cheapest setting tried is good enough already.

    ``own_error`` is that of the converged reference, None where a closed form is the truth.
    """
    errors = _listed([f"{100 * target:g} %" for target in targets])
    parts = [
        f"{NAMES[engine]} {_listed([_price(engines[engine], target) for target in targets])}"
        for engine in NAMES
        if engine in engines
    ]
    against = "" if own_error is None else f", against a rendering that is itself known to {_percent(own_error)}"
    return f"An error of {errors} in the {phenomenon.replace('_', ' ')} costs {'; '.join(parts)}{against}."


def _listed(parts: list[str]) -> str:
    """``a, b and c``; once where all are the same."""
    if len(parts) > 1 and len(set(parts)) == 1:
        return f"{parts[0]} at all" if parts[0].startswith("not") else f"{parts[0]} each"
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def _price(engine: Mapping[str, Any], target: float) -> str:
    price = engine["price_s"][str(target)]
    match price["status"]:
        case "at_most":
            return f"at most {seconds(price['cpu_s'])}"
        case "reached":
            return seconds(price["cpu_s"])
        case "below_reference":
            return "not known"
        case _:
            return "not reached"


def seconds(value: float) -> str:
    return f"{value:.2g} CPU s" if value < 10 else f"{value:.0f} CPU s"


def _percent(error: float) -> str:
    return f"{100 * error:.2g} %"
