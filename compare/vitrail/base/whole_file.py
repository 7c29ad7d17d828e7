"""Files that appear whole or not at all: written beside their place, then moved there.

A reader, and whoever starts after a crash, meets the old file or the new one and never half of either.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from vitrail.base.scratch import scratch_path


@contextmanager
def whole_file(path: Path, *, durable: bool = False) -> Iterator[Path]:
    """Yield a name beside ``path`` to write to; at the end the file is moved to ``path``, or removed after an error.

    The name keeps the suffix, by which image libraries choose a format. The folder is made. ``durable`` brings the
    content to the disk before the move, for what must survive a power cut. An OSError names ``path``.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = scratch_path(".partial-", path.parent, path.suffix)
    try:
        yield partial
        if durable:
            _bring_to_disk(partial)
        os.replace(partial, path)
    except OSError as error:
        if str(error.filename) == str(partial):
            error.filename = str(path)
        raise
    finally:
        partial.unlink(missing_ok=True)


def write_whole(path: Path, content: str | bytes) -> None:
    """Write ``content`` (text as UTF-8) to ``path``, so that no reader ever meets half of it; makes its folder.

    Raises OSError if the disk refuses; what stood at ``path`` before is then untouched.
    """
    with whole_file(path) as partial:
        partial.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)


def _bring_to_disk(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
