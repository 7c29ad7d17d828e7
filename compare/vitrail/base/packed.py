"""Files of data that are compressed where they stand: a name that ends in ``.gz`` is a gzip file."""

from __future__ import annotations

import gzip
from pathlib import Path

from vitrail.base.whole_file import write_whole

SUFFIX = ".gz"


def write_packed(path: Path, text: str) -> None:
    """Write text to a file that appears whole, compressed if its name says so.

    No time and no name goes into the file, so that the same text gives the same bytes.
    """
    write_whole(path, gzip.compress(text.encode("utf-8"), mtime=0) if path.suffix == SUFFIX else text)


def read_packed(path: Path) -> str:
    """The text of a file, compressed or not by its name.

    Raises FileNotFoundError, and OSError or EOFError for a compressed file that is broken.
    """
    content = path.read_bytes()
    return (gzip.decompress(content) if path.suffix == SUFFIX else content).decode("utf-8")


def kind_of(path: Path) -> str:
    """What a file of data is, by its name: ``agreement`` for ``agreement.json.gz``."""
    return path.name.split(".")[0]
