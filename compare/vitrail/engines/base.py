"""What every engine is to the rest of the program: something that turns a lowered scene into an image and a record."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from vitrail.base.progress import Progress, silent


@dataclass(frozen=True)
class Rendering:
    """An image and how it was made. ``record`` is the run record, with the settings that were actually used.

    ``views`` are the images of the views that the lowered scene asks for, by name.
    """

    image_path: Path
    record: dict[str, Any]
    views: Mapping[str, Path] = field(default_factory=dict)

    @property
    def interrupted(self) -> bool:
        """Whether the image holds only the work that was finished when somebody pressed Ctrl-C."""
        return bool(self.record.get("interrupted", False))


def records_of(made: Mapping[str, Rendering]) -> dict[str, dict[str, Any]]:
    """The run records of renderings, by engine."""
    return {side: rendering.record for side, rendering in made.items()}


class EngineFailure(Exception):
    """An engine is missing, crashed, ran out of time or memory, or wrote nothing.

    ``said`` holds the engine's own last words, which are quoted in the message.
    """

    def __init__(self, engine: str, what: str, remedy: str, said: str = "") -> None:
        self.engine, self.what, self.remedy, self.said = engine, what, remedy, said.strip()
        quoted = "".join(f"\n  {engine}: {line}" for line in self.said.splitlines())
        super().__init__(f"{engine}: {what}; {remedy}{quoted}")


class Engine(Protocol):
    """A program that renders."""

    name: str

    def version(self) -> str:
        """The engine's own version; raises EngineFailure when it is not there."""
        ...

    def render(self, lowered: Any, out_dir: Path, *, threads: int = 0, progress: Progress = silent) -> Rendering:
        """Render into ``out_dir``; raises EngineFailure, and leaves ``out_dir`` without an image then."""
        ...
