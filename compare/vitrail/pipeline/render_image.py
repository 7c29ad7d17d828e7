"""One job, one engine, one image with its run record beside it."""

from __future__ import annotations

import os
from pathlib import Path

from vitrail.base.canonical_json import canonical_json
from vitrail.base.engine_name import EngineName
from vitrail.base.progress import Progress, silent
from vitrail.base.scratch import scratch
from vitrail.base.whole_file import write_whole
from vitrail.engines.base import Engine, Rendering
from vitrail.pipeline.job import Job


def render_image(job: Job, engine: Engine, image: Path, *, threads: int = 0, progress: Progress = silent) -> Rendering:
    """Write ``image`` (.exr), and its record as ``.run.json``; both appear whole.

    After Ctrl-C the image may hold the finished part of the work; the record says so. Raises EngineFailure,
    NotTranslatable, and KeyboardInterrupt where nothing was finished.
    """
    image.parent.mkdir(parents=True, exist_ok=True)
    with scratch(f".{image.stem}-", image.parent) as work:
        lowered = job.lowered(EngineName(engine.name))
        made = engine.render(lowered, work, threads=threads, progress=progress)
        write_whole(image.with_suffix(".run.json"), canonical_json(made.record))
        os.replace(made.image_path, image)
    return Rendering(image, made.record)
