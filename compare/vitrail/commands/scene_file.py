"""Read a scene for a command: errors stop it, warnings are said on stderr."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from vitrail.scene.diagnostic import Diagnostic
    from vitrail.scene.load import Loaded


def read_scene(path: Path) -> Loaded:
    """A scene that can be rendered; raises SceneErrors."""
    loaded, warnings = read_and_check(path)
    for warning in warnings:
        typer.echo(str(warning), err=True)
    return loaded


def read_and_check(path: Path) -> tuple[Loaded, tuple[Diagnostic, ...]]:
    """A scene and its warnings; raises SceneErrors with every error of the file and of its cross checks."""
    from vitrail.check.check import check_file

    result = check_file(path)
    return result.scene_or_raise(), result.warnings
