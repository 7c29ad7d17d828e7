"""``vitrail plan``: what a scene requires, phenomenon by phenomenon, with evidence and cost."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from vitrail.commands.exit_code import exit_codes
from vitrail.commands.output import print_json

if TYPE_CHECKING:
    from vitrail.plan.budget import Settings
    from vitrail.plan.plan import Plan


def plan(
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    as_json: bool = typer.Option(False, "--json", help="Print the plan as JSON."),
) -> None:
    with exit_codes():
        from vitrail.commands.scene_file import read_scene
        from vitrail.plan.analyse import analyse
        from vitrail.plan.budget import settings_for

        loaded = read_scene(scene)
        found = analyse(loaded.scene)
        settings = settings_for(loaded.scene, found)
    if as_json:
        print_json(_plain(found, settings))
    else:
        _print_table(loaded.scene.title or scene.name, found, settings)


def _plain(found: Plan, settings: Settings) -> dict[str, Any]:
    return {
        "phenomena": {phenomenon.value: asdict(entry) for phenomenon, entry in found.entries.items()},
        "caustic_paths": [asdict(path) for path in found.caustic_paths],
        "chain": asdict(found.chain),
        "warnings": list(found.warnings),
        "settings": asdict(settings),
    }


def _print_table(title: str, found: Plan, settings: Settings) -> None:
    """One row a phenomenon; then the chain, the settings that follow, and what was left out."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    console = Console()
    table = Table(title=escape(title), title_justify="left", show_lines=True)
    table.add_column("phenomenon")
    table.add_column("required")
    table.add_column("evidence", overflow="fold")
    table.add_column("cost", overflow="fold")
    for phenomenon, entry in found.entries.items():
        answer = "[bold]yes[/]" if entry.required else "[dim]no[/]"
        table.add_row(phenomenon.value, answer, escape("\n".join(entry.evidence)), escape(entry.cost))
    console.print(table)
    chain = found.chain
    console.print(
        f"longest chain: {chain.reflections} reflections, {chain.transmissions} transmissions ({escape(chain.reason)})"
    )
    console.print(
        f"at normal quality: {settings.samples} samples a pixel, {settings.photons} photons,"
        f" gather radius {settings.gather_radius_m:g} m"
    )
    for warning in found.warnings:
        typer.echo(f"warning: {warning}", err=True)
