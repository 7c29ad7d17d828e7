"""``vitrail mutants``: inject known defects and show which of them the verdicts catch, and by what name."""

from __future__ import annotations

from pathlib import Path

import typer

from vitrail.commands.exit_code import DEVIATES, exit_codes, usage_error
from vitrail.commands.output import print_json


def mutants(
    bench: Path = typer.Option(Path("scenes/calibration"), "--bench", help="The folder of the calibration scenes."),
    out: Path = typer.Option(Path("out/mutants"), "--out", metavar="DIR", help="Folder of the study; call to resume."),
    only: list[str] = typer.Option([], "--only", help="Only this mutant; may be given several times."),
    as_json: bool = typer.Option(False, "--json", help="Print the matrix as JSON."),
) -> None:
    """Exit code 1 when a mutant escapes."""
    with exit_codes():
        from vitrail.commands.study_options import study_progress
        from vitrail.report.mutants_page import write_mutants_page
        from vitrail.study.mutants.catalogue import MUTANTS
        from vitrail.study.mutants.run import run_mutants

        names = [known.name for known in MUTANTS]
        unknown = [name for name in only if name not in names]
        if unknown:
            raise usage_error(f"--only {unknown[0]}: there is no such mutant; choose from {', '.join(names)}")
        chosen = [known for known in MUTANTS if not only or known.name in only]
        with study_progress("mutants") as report:
            found = run_mutants(bench, out, mutants=chosen, report=report)
        page = write_mutants_page(out, found)
    if as_json:
        print_json(found)
    else:
        for entry in found["mutants"]:
            typer.echo(_words(entry))
        total = len(found["mutants"])
        typer.echo(f"{found['caught']} of {total} caught, {found['named']} named right; the page is {page}")
    raise typer.Exit(0 if found["caught"] == len(found["mutants"]) else DEVIATES)


def _words(entry: dict) -> str:
    """One mutant in a line."""
    if entry["failure"]:
        return f"{entry['name']}: {entry['failure']}"
    seen = entry["reported"] or "nothing"
    return f"{entry['name']} ({entry['injected']}, {entry['injected_engine']}): reported {seen}, {entry['engine']}"
