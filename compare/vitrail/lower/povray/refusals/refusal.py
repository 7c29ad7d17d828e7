"""What cannot be said in POV-Ray's language, with the line of the scene that asks for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.load import Loaded


class NotTranslatable(Exception):
    """The scene asks for something that POV-Ray 3.7 cannot render within a stated error (exit code 3)."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("\n".join(str(each) for each in self.diagnostics))


@dataclass(frozen=True)
class Refusals:
    """Finds the line of a part of the scene; a scene that was built in memory has none and says so."""

    loaded: Loaded | None = None

    def at(self, what: str, remedy: str, *path: str | int) -> Diagnostic:
        if self.loaded is not None:
            return self.loaded.at(what, remedy, *path)
        place = ".".join(str(step) for step in path)
        return Diagnostic("(scene in memory)", 1, 1, f"{place}: {what}" if place else what, remedy)
