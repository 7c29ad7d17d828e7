"""A file that grows by one JSON record at a time and is whole after a kill at any moment.

For what is replaced as a whole there is ``whole_file``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from vitrail.base.canonical_json import json_line

T = TypeVar("T")


def append_line(path: Path, record: Any) -> None:
    """Add a record and bring it to the disk before anything else happens. Raises OSError."""
    with path.open("ab") as file:
        file.write(json_line(record).encode() + b"\n")
        file.flush()
        os.fsync(file.fileno())


def whole_lines(path: Path, read: Callable[[Any], T]) -> list[T]:
    """Every record from the first on, up to one that a kill has torn; that and what follows it is cut off the file.

    ``read`` makes a value of a record, and raises ValueError, KeyError or TypeError for one that is damaged. A file
    that is not there has none.
    """
    found: list[T] = []
    if not path.exists():
        return found
    whole_bytes = 0
    for line in path.read_bytes().splitlines(keepends=True):
        try:
            if not line.endswith(b"\n"):
                break
            found.append(read(json.loads(line)))
        except (ValueError, KeyError, TypeError):
            break
        whole_bytes += len(line)
    # Cut the tail off, so that the next record begins on a line of its own.
    with path.open("r+b") as file:
        file.truncate(whole_bytes)
    return found
