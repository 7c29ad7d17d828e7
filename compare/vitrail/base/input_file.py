"""Files that somebody else wrote: read whole, and only where they are regular files of a bounded size.

A pipe would let us wait for ever, a device has no end, and a sparse file is larger than any memory.
"""

from __future__ import annotations

import os
import stat
from pathlib import Path


class InputFileError(Exception):
    """A file cannot be read; the message says why, as the rest of a sentence that begins with its name."""


def look_at(path: Path) -> os.stat_result:
    """Size and times of a regular file. Raises InputFileError for anything else."""
    try:
        found = path.stat()
    except (OSError, ValueError) as error:
        raise InputFileError(f"cannot be read ({_reason(error)})") from None
    if not stat.S_ISREG(found.st_mode):
        raise InputFileError("is a folder" if stat.S_ISDIR(found.st_mode) else "is no regular file")
    return found


def read_bytes(path: Path, most_bytes: int) -> bytes:
    """All of a regular file. Raises InputFileError."""
    size = look_at(path).st_size
    if size > most_bytes:
        raise InputFileError(f"has {size:.3g} bytes, and at most {most_bytes:.3g} are read")
    try:
        with path.open("rb") as file:
            content = file.read(most_bytes + 1)
    except OSError as error:
        raise InputFileError(f"cannot be read ({_reason(error)})") from None
    if len(content) > most_bytes:
        raise InputFileError(f"grows while it is read, beyond {most_bytes:.3g} bytes")
    return content


def leads_out_of(folder: Path, name: str) -> bool:
    """Whether a name that stays in a folder by its letters leaves it by a link."""
    written = Path(os.path.normpath(folder / name))
    home, real = Path(os.path.realpath(folder)), Path(os.path.realpath(written))
    return written.is_relative_to(os.path.normpath(folder)) and not real.is_relative_to(home)


def _reason(error: OSError | ValueError) -> str:
    return (getattr(error, "strerror", None) or str(error)).lower()
