"""A mutant: one defect, where it sits, and the phenomenon by which it must be named."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from vitrail.base.phenomenon import Phenomenon
from vitrail.pipeline.defect import Defect

Place = Literal["translator", "tracer"]
ENGINE_OF: dict[Place, str] = {"translator": "povray", "tracer": "tracer"}


@dataclass(frozen=True)
class Mutant:
    """``what`` says the mistake as its author would find it in the code."""

    name: str
    place: Place
    phenomenon: Phenomenon
    what: str
    defect: Defect

    @property
    def engine(self) -> str:
        """The engine whose image the defect spoils."""
        return ENGINE_OF[self.place]
