"""``vitrail doctor``: what is installed, in which version, what is missing, and what to do about it."""

from __future__ import annotations

import typer

from vitrail.base.exit_code import ExitCode
from vitrail.commands.output import print_json, wide_console


def doctor(as_json: bool = typer.Option(False, "--json", help="Print the findings as JSON.")) -> None:
    """Ends with 4 when something is missing that rendering or comparing needs."""
    from vitrail.engines.installation import Finding, findings

    found: list[Finding] = findings()
    missing = [each for each in found if each.is_needed and not each.is_there]
    if as_json:
        print_json({"ready": not missing, "parts": [each.as_record() for each in found]})
    else:
        _print_table(found)
        count = len(missing)
        typer.echo("Everything that is needed is there." if not missing else f"Missing parts: {count}. See `to do`.")
    if missing:
        raise typer.Exit(ExitCode.ENGINE_FAILED)


def _print_table(found: list) -> None:
    """One row a part: whether it is there, its version and place, what it is for, what to do."""
    from rich.markup import escape
    from rich.table import Table

    table = Table(title="What Vitrail works with", title_justify="left")
    for column in ("part", "there", "version", "for", "to do"):
        table.add_column(column, overflow="fold")
    for each in found:
        state = "yes" if each.is_there else ("NO" if each.is_needed else "no")
        table.add_row(*(escape(text) for text in (each.part, state, each.version, each.purpose, each.to_do)))
    wide_console().print(table)
