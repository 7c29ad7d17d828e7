"""``vitrail plan``: what a scene requires, phenomenon by phenomenon, with evidence and cost."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from vitrail.commands.errors import exit_codes
from vitrail.commands.output import print_json, wide_console

if TYPE_CHECKING:
    from vitrail.plan.plan import Plan
    from vitrail.plan.settings import Settings
    from vitrail.plan.solver_choice import SolverChoice


def plan(
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    as_json: bool = typer.Option(False, "--json", help="Print the plan as JSON."),
) -> None:
    with exit_codes():
        from vitrail.commands.scene_file import read_scene
        from vitrail.pipeline.job import prepare
        from vitrail.plan.settings import Solver
        from vitrail.plan.solver_choice import solver_choice

        loaded = read_scene(scene)
        job = prepare(loaded, overrides={"solver": Solver.AUTO})
        found, settings = job.plan, job.settings
        solver = solver_choice(job.scene, found, settings)
    for warning in found.warnings:
        typer.echo(f"warning: {warning}", err=True)
    if as_json:
        print_json(_as_json(found, settings, solver))
    else:
        _print_table(loaded.scene.title or scene.name, found, settings, solver)


def _as_json(found: Plan, settings: Settings, solver: SolverChoice | None) -> dict[str, Any]:
    return {
        "phenomena": {phenomenon.value: asdict(entry) for phenomenon, entry in found.entries.items()},
        "caustic_paths": [asdict(path) for path in found.caustic_paths],
        "chain": asdict(found.chain),
        "warnings": list(found.warnings),
        "settings": settings.as_record(),
        "solver": None if solver is None else asdict(solver),
    }


def _print_table(title: str, found: Plan, settings: Settings, solver: SolverChoice | None) -> None:
    """What is required, with evidence and cost; what is not, and why; the chain and the settings that follow."""
    from rich.markup import escape
    from rich.table import Table

    required = Table(title=escape(title), title_justify="left", show_lines=True)
    for column in ("required", "evidence", "cost"):
        required.add_column(column, overflow="fold")
    spared = Table(show_header=True)
    for column in ("not required", "because"):
        spared.add_column(column, overflow="fold")
    for phenomenon, entry in found.entries.items():
        reasons = escape("\n".join(entry.evidence))
        if entry.required:
            required.add_row(phenomenon.value, reasons, escape(entry.cost))
        else:
            spared.add_row(phenomenon.value, reasons)
    console = wide_console()
    console.print(required)
    console.print(spared)
    console.print(_summary(found, settings, solver), markup=False, highlight=False)


def _summary(found: Plan, settings: Settings, solver: SolverChoice | None) -> str:
    chain = found.chain
    solved = f"\ncaustics by {solver.solver}: {solver.because}" if solver else ""
    return (
        f"longest chain: {chain.reflections} reflections, {chain.transmissions} transmissions ({chain.reason})\n"
        f"at normal quality: {settings.samples} samples per pixel, {settings.photons} photons,"
        f" gather radius {settings.gather_radius_m:g} m{solved}"
    )
