"""How commands write on stdout: JSON, and tables as wide as the terminal."""

from __future__ import annotations

import json
import sys
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
