"""What an author probably meant by a name that nobody knows."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name most like ``name``, or None when none is close."""
    choices = list(known)
    lowered = {choice.lower(): choice for choice in reversed(choices)}
    found = difflib.get_close_matches(name.lower(), list(lowered), n=1, cutoff=0.6)
    return lowered[found[0]] if found else None


def suggestion(name: str, known: Iterable[str], noun: str) -> str:
    """The remedy for an unknown name: the nearest known one, or the list of all."""
    choices = list(known)
    close = nearest(name, choices)
    if close is not None:
        return f"did you mean `{close}`?"
    if not choices:
        return f"there are no {noun}s to choose from"
    return f"the {noun}s are {', '.join(choices)}"
