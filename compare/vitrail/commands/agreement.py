"""``vitrail agreement``: finished comparisons as one table of what the engines agree on, and how far."""

from __future__ import annotations

from pathlib import Path

import typer

from vitrail.commands.errors import exit_codes, usage_error


def agreement(
    folders: list[Path] = typer.Argument(..., metavar="DIR...", help="Folders with results.json, the last one counts."),
    out: Path = typer.Option(Path("docs/agreement.json.gz"), "--out", help="The file of all rows."),
    page: Path = typer.Option(Path("docs/agreement.md"), "--page", help="The page whose tables are written again."),
) -> None:
    """Read, sort, count, write; nothing is rendered or measured again."""
    with exit_codes():
        from pydantic import ValidationError

        from vitrail.base.record import write_record
        from vitrail.judge.records import read_results
        from vitrail.report.agreement_page import count_line, write_agreement_page
        from vitrail.study.agreement import agreement as agreement_of

        try:
            found = agreement_of([read_results(folder / "results.json") for folder in folders])
        except FileNotFoundError as error:
            raise usage_error(f"{error.filename}: is not there; run `vitrail compare ... --out DIR` first") from None
        except ValidationError as error:
            raise usage_error(f"{error.errors()[0]['msg']}; compare the scenes again") from None
        write_record(found, out)
        write_agreement_page(page, found)
    typer.echo(count_line(found))
