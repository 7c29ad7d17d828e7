"""One picture of hand-written scene text, inside the same walls as a lowered scene, with nothing undone or averaged.

The studies use it to see what POV-Ray does with a scene as a user would write it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vitrail.base.scratch import scratch
from vitrail.engines.base import EngineFailure
from vitrail.engines.child import Limits, run_child
from vitrail.engines.povray import Povray
from vitrail.engines.povray_command import IMAGE, picture_command
from vitrail.engines.povray_output import complaint_of
from vitrail.images.exr import read_image

MEMORY_BYTES = 4 << 30
"""Address space that one picture may take."""


@dataclass(frozen=True)
class TextPicture:
    """``radiance`` (height, width, 3) as POV-Ray wrote it, in its own units; ``cpu_s`` of the whole process."""

    radiance: np.ndarray
    cpu_s: float
    peak_memory_bytes: int


def render_text(sdl: str, width: int, height: int, *, engine: Povray | None = None, wall_s: float = 600) -> TextPicture:
    """Raises EngineFailure with POV-Ray's own words when there is no picture."""
    povray = engine or Povray()
    with scratch("vitrail-povray-") as folder:
        isolated = picture_command(povray.program, sdl, width, height, folder, MEMORY_BYTES)
        finished = run_child(isolated.command, limits=Limits(wall_s=wall_s))
        if finished.interrupted:
            raise KeyboardInterrupt
        image = folder / IMAGE
        if finished.code != 0 or not image.is_file():
            remedy = "its words follow"
            raise EngineFailure(povray.name, f"it {finished.ending()}", remedy, complaint_of(finished.said))
        radiance = read_image(image).radiance
    return TextPicture(radiance, finished.cpu_s, finished.peak_memory_bytes)
