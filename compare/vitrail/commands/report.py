"""``vitrail report``: the pages of a finished comparison, written again."""

from __future__ import annotations

from pathlib import Path

import typer

from vitrail.commands.comparison_options import reference_errors
from vitrail.commands.errors import exit_codes, usage_error


def report(
    folder: Path = typer.Argument(..., metavar="DIR", help="A folder with results.json and its images."),
) -> None:
    """Build the pages from results.json; nothing is measured again."""
    with exit_codes(), reference_errors():
        from pydantic import ValidationError

        from vitrail.report.build import build_report

        try:
            page = build_report(folder)
        except FileNotFoundError:
            raise usage_error(
                f"{folder}: holds no results.json; run `vitrail compare ... --out {folder}` first"
            ) from None
        except ValidationError as error:
            first = error.errors()[0]
            where = ".".join(str(step) for step in first["loc"])
            raise usage_error(f"{folder}/results.json: {where}: {first['msg']}; compare the scenes again") from None
    typer.echo(str(page))
