"""Files that a scene names and that lie beside it."""

from __future__ import annotations

from vitrail.check.findings import Findings


def file_problem(findings: Findings, file: str) -> str | None:
    """What is wrong with a file that a scene names, None when it can be read."""
    found = findings.loaded.path.parent / file
    try:
        if found.is_dir():
            return f"`{file}` is a folder"
        if not found.is_file():
            return f"there is no file `{file}`"
        if found.stat().st_size == 0:
            return f"the file `{file}` is empty"
    except (OSError, ValueError) as error:
        return f"the file `{file[:60]}` cannot be read ({getattr(error, 'strerror', None) or error})"
    return None
