"""The names of a scene as identifiers of POV-Ray: a capital first, and no two alike."""

from __future__ import annotations

import re

from vitrail.lower.povray.text.sdl import Identifier

LONGEST = 20
"""Characters of a name that are kept; POV-Ray reads 40, and a prefix, a suffix and a number need room."""
FOREIGN = re.compile(r"[^A-Za-z0-9]+")


class Identifiers:
    """Gives every name of a scene its identifier, once."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def new(self, name: str, *, prefix: str = "", suffix: str = "") -> Identifier:
        """``glass ball`` as ``Glass_ball``; a number follows where that is taken or nothing is left of the name."""
        words = FOREIGN.sub("_", name).strip("_")[:LONGEST]
        stem = f"{prefix}{words[:1].upper()}{words[1:]}{suffix}"
        if not words or not stem[0].isalpha():
            stem = f"{prefix or 'Part_'}{words}{suffix}"
        found, count = stem, 1
        while found in self._taken:
            count += 1
            found = f"{stem}_{count}"
        self._taken.add(found)
        return Identifier(found)


def file_stem(name: str) -> str:
    """A name for a file that is safe on a command line: letters, digits and single underscores."""
    return FOREIGN.sub("_", name).strip("_") or "scene"
