"""What a reader of the report decided about its images, as the report exports it."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Literal

from pydantic import BaseModel, ConfigDict, ValidationError

from vitrail.judge.reference_files import ReferencesError


class Choice(StrEnum):
    """Whether an image is to be the reference of its scene from now on."""

    ACCEPT = "accept"
    REJECT = "reject"


class Decision(BaseModel):
    """One image, decided on. ``content`` is the hash of the pixels that the reader saw, ``because`` the reason."""

    model_config = ConfigDict(frozen=True)

    scene: str
    decision: Choice
    because: str
    content: str


class Decisions(BaseModel):
    """All decisions about one run; ``folder`` is where its results were."""

    model_config = ConfigDict(frozen=True)

    vitrail_decisions: Literal[1]
    folder: Path = Path()
    decisions: tuple[Decision, ...]

    @property
    def accepted(self) -> dict[str, Decision]:
        """Scene to decision, of the accepted images."""
        return {each.scene: each for each in self.decisions if each.decision is Choice.ACCEPT}


def read_decisions(path: Path) -> Decisions:
    """The decisions of an exported file. Raises ReferencesError."""
    try:
        return Decisions.model_validate_json(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, ValidationError):
        raise ReferencesError(f"{path}: is no file of decisions; export one from the report") from None
