"""What a comparison is asked to do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from vitrail.engines.base import Engine
from vitrail.engines.povray import Povray
from vitrail.engines.tracer import Tracer
from vitrail.pipeline.defect import Defect
from vitrail.plan.settings import Quality
from vitrail.plan.views import PICTURE_WIDTH

BUDGET_S = 60.0
"""CPU seconds per scene that a run may cost beyond its first looks: a minute is what a person waits for an answer."""


@dataclass(frozen=True)
class Request:
    """Scenes and settings of one run. ``overrides`` replace fields of the settings; ``out`` holds the results.

    ``against`` says what the tracer is held against beside closed forms: ``povray``, ``stored`` (its own accepted
    image, made again by that image's recipe), both, or nothing. ``threads`` 0 takes every core; ``jobs`` scenes are
    worked on at a time. With ``views`` every observation is measured in a picture of its own, and the scene's
    own picture has at least ``picture_width`` pixels across. After the first look up
    to ``rounds`` more buy samples for what is in doubt, for at most ``budget_s`` CPU seconds over all scenes; None is
    a minute per scene, shared. ``references`` is the folder of closed forms, thresholds and stored images, or None for
    the one nearest to each scene.
    """

    out: Path
    quality: Quality = Quality.NORMAL
    overrides: Mapping[str, object] = field(default_factory=dict)
    threads: int = 0
    jobs: int = 1
    views: bool = True
    picture_width: int = PICTURE_WIDTH
    rounds: int = 0
    budget_s: float | None = None
    references: Path | None = None
    defect: Defect = Defect()
    against: tuple[str, ...] = ("povray",)
    engines: Mapping[str, Engine] = field(default_factory=lambda: {"tracer": Tracer(), "povray": Povray()})
    command: tuple[str, ...] = ()

    def suite_budget_s(self, scenes: int) -> float:
        """CPU seconds that so many scenes together may cost beyond their first looks."""
        return BUDGET_S * scenes if self.budget_s is None else self.budget_s

    @property
    def cache(self) -> Path:
        """Finished renderings, kept by content, so that an interrupted run goes on where it was."""
        return self.out / ".cache"
