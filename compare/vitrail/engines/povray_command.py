"""POV-Ray's command line: one picture of a scene text, inside walls."""

from __future__ import annotations

from pathlib import Path

from vitrail.engines.isolate import Allowance, Isolated, isolate

SCENE, IMAGE = "scene.pov", "image.exr"


def picture_command(program: Path, sdl: str, width: int, height: int, folder: Path, memory_bytes: int) -> Isolated:
    """Write the text into ``folder``; the command renders it there into ``image.exr``, linear half floats.

    One thread, because photons differ with the number of threads [P 6], and no antialiasing of POV-Ray's own.
    """
    (folder / SCENE).write_text(sdl, encoding="ascii")
    arguments = [f"+I{SCENE}", f"+O{IMAGE}", f"+W{width}", f"+H{height}", "+FE", "-D", "-A", "+WT1"]
    return isolate(program, arguments, folder, Allowance(memory_bytes=memory_bytes))
