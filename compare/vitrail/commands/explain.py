"""``vitrail explain``: the certificate, what POV-Ray cannot express exactly and by how much."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from vitrail.commands.exit_code import exit_codes
from vitrail.commands.output import print_json, wide_console
from vitrail.commands.settings_options import QUALITY, SETTINGS, parse_settings

if TYPE_CHECKING:
    from vitrail.lower.povray.certificate import Certificate


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
        certificate = lower_povray(loaded.scene, found, chosen, loaded).certificate
    if as_json:
        print_json({"scene": str(scene), "certificate": certificate.as_records()})
    else:
        _print_table(loaded.scene.title or scene.name, certificate)


def _print_table(title: str, certificate: Certificate) -> None:
    """One row for each item that was translated."""
    from rich.markup import escape
    from rich.table import Table

    table = Table(title=escape(title), title_justify="left", show_lines=True)
    for column in ("phenomenon", "item", "meant", "POV-Ray has", "residual", "because"):
        table.add_column(column, overflow="fold")
    for entry in certificate.entries:
        laws = (escape(entry.source_law), escape(entry.target_law))
        residual = f"{entry.residual:.2g} {entry.unit}".strip()
        table.add_row(str(entry.phenomenon), escape(entry.item), *laws, escape(residual), escape(entry.reason))
    wide_console().print(table)
