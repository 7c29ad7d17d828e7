"""How commands write: JSON on stdout, and files that appear whole or not at all."""

from __future__ import annotations

import json
import os
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

if TYPE_CHECKING:
    from rich.console import Console

PAGE_WIDTH = 120
"""Columns of a table that goes into a file or a pipe."""


def print_json(value: Any) -> None:
    """The machine form of what a command prints."""
    typer.echo(json.dumps(value, indent=2, allow_nan=False))


def wide_console() -> Console:
    """Where tables go: as wide as the terminal, and wide enough to read where there is none."""
    from rich.console import Console

    return Console() if sys.stdout.isatty() else Console(width=PAGE_WIDTH)


def write_whole(path: Path, text: str) -> None:
    """Write a file beside its place and move it there, so that no reader ever meets half of it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        os.unlink(name)
        raise
