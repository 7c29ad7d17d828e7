"""One scene on its way: its numbers, which wait for the verdict that only all scenes together can give."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from vitrail.judge.judgement import Residual
from vitrail.judge.observe import Observed
from vitrail.judge.purchase import Purchase
from vitrail.judge.records import SceneResult
from vitrail.pipeline.ablate import Search
from vitrail.pipeline.request import Request
from vitrail.scene.load import Loaded


@dataclass(frozen=True)
class SceneTask:
    """One scene to be rendered and measured, by the name of its folder in the results. Its run depends on it alone.

    ``purchase`` asks for another look, at some views alone; ``look`` counts from 1.
    """

    name: str
    loaded: Loaded
    request: Request
    purchase: Purchase | None = None
    look: int = 1


@dataclass(frozen=True)
class SceneRun:
    """A scene's record without verdicts, its numbers, and what the certificate allows for each phenomenon.

    ``search`` is what was tried to find where its engines deviate.
    """

    record: SceneResult
    observed: tuple[Observed, ...] = ()
    residual: Residual = lambda phenomenon, whole_over_light: 0.0
    references: Path | None = None
    search: Search = Search()
