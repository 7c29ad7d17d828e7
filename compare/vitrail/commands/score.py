"""``vitrail score``: the same verdicts for images that any program made."""

from __future__ import annotations

import sys
from pathlib import Path

import typer

from vitrail.commands.comparison_options import reference_errors
from vitrail.commands.exit_code import exit_codes
from vitrail.commands.output import print_json


def score(
    scene: Path = typer.Argument(..., metavar="SCENE", help="The scene that both images show."),
    candidate: Path = typer.Argument(..., metavar="CANDIDATE.exr", help="The image to judge."),
    reference: Path = typer.Argument(..., metavar="REFERENCE.exr", help="The image to judge it by."),
    out: Path = typer.Option(..., "--out", help="The folder for report and results."),
    references: Path | None = typer.Option(None, "--references", help="The folder of closed forms and thresholds."),
    as_json: bool = typer.Option(False, "--json", help="Print results.json instead of the table."),
) -> None:
    """Gates, measure, judge, report."""
    with exit_codes(), reference_errors():
        from vitrail.commands.scene_file import read_scene
        from vitrail.commands.verdict_table import print_results
        from vitrail.report.build import build_report
        from vitrail.study.compare.score import score as score_images

        loaded = read_scene(scene)
        files = {"candidate": candidate, "reference": reference}
        command = ("vitrail", *sys.argv[1:])
        results = score_images(loaded, files, out, references=references, command=command)
        page = build_report(out)
        if as_json:
            print_json(results.model_dump(mode="json"))
        else:
            print_results(results, page)
    raise typer.Exit(results.exit_code)
