"""Run a job in one engine, and get its whole image or none."""

from __future__ import annotations

from pathlib import Path

from vitrail.base.engine_name import EngineName
from vitrail.base.progress import Progress, silent
from vitrail.engines.base import Engine, Rendering
from vitrail.pipeline.job import Job


def run(job: Job, engine: Engine, out: Path, *, threads: int = 0, progress: Progress = silent) -> Rendering:
    """Render into the folder ``out``; ``threads`` 0 takes every core.

    Raises EngineFailure, NotTranslatable, and KeyboardInterrupt where somebody stopped it.
    """
    lowered = job.lowered(EngineName(engine.name))
    return finished(engine.render(lowered, out, threads=threads, progress=progress))


def finished(rendering: Rendering) -> Rendering:
    """The rendering, if it is whole. One that was cut short is never measured: KeyboardInterrupt is raised for it."""
    if rendering.interrupted:
        raise KeyboardInterrupt
    return rendering
