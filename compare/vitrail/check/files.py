"""Files that a scene names and that lie beside it."""

from __future__ import annotations

from pathlib import Path

from vitrail.base.input_file import InputFileError, leads_out_of, look_at
from vitrail.check.findings import Findings


def file_problem(findings: Findings, file: str) -> str | None:
    """What is wrong with a file that a scene names, None when it can be read."""
    folder, shown = findings.loaded.path.parent, file if len(file) <= 60 else f"{file[:57]}..."
    try:
        found = look_at(folder / file)
    except InputFileError as error:
        return f"there is no file `{shown}`" if not _exists(folder / file) else f"`{shown}` {error}"
    if found.st_size == 0:
        return f"the file `{shown}` is empty"
    if leads_out_of(folder, file):
        return f"`{shown}` is a link out of the scene's folder"
    return None


def _exists(file: Path) -> bool:
    """Whether anything is there that has the name, be it a link to nothing."""
    try:
        file.lstat()
    except FileNotFoundError:
        return False
    except (OSError, ValueError):
        return True
    return True
