"""``vitrail explain``: the certificate, what POV-Ray cannot express exactly and by how much."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from vitrail.base.engine_name import EngineName
from vitrail.commands.errors import exit_codes
from vitrail.commands.output import print_json, wide_console
from vitrail.commands.settings_options import QUALITY, SETTINGS, prepared
from vitrail.plan.settings import Quality

if TYPE_CHECKING:
    from vitrail.lower.povray.certificate.certificate import Certificate, Entry


def explain(
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    quality: Quality = QUALITY,
    settings: list[str] = SETTINGS,
    as_json: bool = typer.Option(False, "--json", help="Print the certificate as JSON."),
) -> None:
    with exit_codes():
        from vitrail.commands.scene_file import read_scene

        loaded = read_scene(scene)
        certificate = prepared(loaded, quality, settings).lowered(EngineName.POVRAY).certificate
    if as_json:
        print_json({"scene": str(scene), "certificate": certificate.as_json()})
    else:
        _print_table(loaded.scene.title or scene.name, certificate)


def _print_table(title: str, certificate: Certificate) -> None:
    """One row for each law; the phenomena it acts on stand together."""
    from rich.markup import escape
    from rich.table import Table

    table = Table(title=escape(title), title_justify="left", show_lines=True)
    for column in ("phenomenon", "item", "meant", "POV-Ray has", "residual", "because"):
        table.add_column(column, overflow="fold")
    for entry, phenomena in _by_law(certificate).items():
        laws = (escape(entry.source_law), escape(entry.target_law))
        residual = f"{entry.residual:.2g} {entry.unit}".strip()
        table.add_row(phenomena, escape(str(entry.item)), *laws, escape(residual), escape(entry.reason))
    wide_console().print(table)


def _by_law(certificate: Certificate) -> dict[Entry, str]:
    """The first entry of each law, and all phenomena that share it, in words."""
    first: dict[tuple[Any, ...], Entry] = {}
    phenomena: dict[Entry, list[str]] = {}
    for entry in certificate.entries:
        law = (entry.item, entry.source_law, entry.target_law, entry.residual, entry.unit, entry.reason)
        phenomena.setdefault(first.setdefault(law, entry), []).append(entry.phenomenon.value.replace("_", " "))
    every = {entry.phenomenon for entry in certificate.entries}
    return {
        entry: "every phenomenon" if len(names) == len(every) > 1 else ", ".join(names)
        for entry, names in phenomena.items()
    }
