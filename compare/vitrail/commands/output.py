"""How commands write: JSON on stdout, and files that appear whole or not at all."""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path
from typing import Any

import typer


def print_json(value: Any) -> None:
    """The machine form of what a command prints."""
    typer.echo(json.dumps(value, indent=2, allow_nan=False))


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
