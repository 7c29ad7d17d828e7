"""How evidence is worded: short numbers, short lists."""

from __future__ import annotations

import math
from collections.abc import Sequence

from vitrail.plan.plan import Requirement

LONGEST_LIST = 8
"""Items of evidence that are written out; the rest is counted."""

NO_COST = "none"


def needed(evidence: Sequence[str], cost: str, left_out: Sequence[str] = ()) -> Requirement:
    """A required phenomenon with its reasons, and what of it is left out nevertheless."""
    shown = tuple(evidence[:LONGEST_LIST])
    rest = len(evidence) - len(shown)
    return Requirement(True, (*shown, f"and {rest} more") if rest else shown, cost, tuple(left_out))


def not_needed(reason: str, left_out: Sequence[str] = ()) -> Requirement:
    """A phenomenon that takes no part, or whose part is left out for being below the stated error."""
    return Requirement(False, tuple(left_out) or (reason,), NO_COST, tuple(left_out))


def colour(value: Sequence[float]) -> str:
    """One number for grey, three for a colour."""
    if len(set(value)) == 1:
        return f"{value[0]:.3g}"
    return "[" + ", ".join(f"{part:.3g}" for part in value) + "]"


def pixels(value: float) -> str:
    return "more than 10000 px" if value > 1e4 else f"{value:.2g} px" if value < 10 else f"{value:.0f} px"


def degrees(radians: float) -> str:
    return f"{math.degrees(radians):.3g} deg"
