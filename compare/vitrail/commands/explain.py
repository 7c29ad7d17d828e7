"""``vitrail explain``: the certificate, what POV-Ray cannot express exactly and by how much."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import typer

from vitrail.commands.exit_code import exit_codes
from vitrail.commands.output import print_json
from vitrail.commands.settings_options import QUALITY, SETTINGS, parse_settings


def explain(
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    quality: str = QUALITY,
    settings: list[str] = SETTINGS,
    as_json: bool = typer.Option(False, "--json", help="Print the certificate as JSON."),
) -> None:
    with exit_codes():
        from vitrail.commands.scene_file import read_scene
        from vitrail.lower.povray import lower_povray
        from vitrail.plan.analyse import analyse

        loaded = read_scene(scene)
        found = analyse(loaded.scene)
        chosen = parse_settings(loaded.scene, found, quality, settings)
        entries = lower_povray(loaded.scene, found, chosen).certificate.entries
    if as_json:
        print_json({"scene": str(scene), "certificate": [asdict(entry) for entry in entries]})
    else:
        _print_table(loaded.scene.title or scene.name, entries)


def _print_table(title: str, entries: Any) -> None:
    """One row for each item that was translated."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table(title=escape(title), title_justify="left", show_lines=True)
    for column in ("phenomenon", "item", "meant", "POV-Ray has", "residual", "because"):
        table.add_column(column, overflow="fold")
    for entry in entries:
        laws = (escape(entry.source_law), escape(entry.target_law))
        residual = f"{entry.residual:.2g} {entry.unit}".strip()
        table.add_row(str(entry.phenomenon), escape(entry.item), *laws, escape(residual), escape(entry.reason))
    Console().print(table)
