"""``vitrail score``: the same verdicts for images that any program made."""

from __future__ import annotations

import sys
from pathlib import Path

import typer

from vitrail.commands.comparison_options import reference_errors
from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.result_formats import VERBOSE, Format, print_in


def score(
    scene: Path = typer.Argument(..., metavar="SCENE", help="The scene that both images show."),
    candidate: Path = typer.Argument(
        None, metavar="[CANDIDATE.exr]", help="The image to judge; not needed where --views gives them."
    ),
    reference: Path = typer.Argument(
        None, metavar="[REFERENCE.exr]", help="The image to judge it by; without one closed forms alone judge."
    ),
    views: Path | None = typer.Option(
        None, "--views", help="The folder of the images that `vitrail emit views` lists; they are measured."
    ),
    reference_views: Path | None = typer.Option(
        None, "--reference-views", help="The same of the renderer to judge by; without it closed forms alone judge."
    ),
    out: Path = typer.Option(..., "--out", help="The folder for report and results."),
    references: Path | None = typer.Option(None, "--references", help="The folder of closed forms and thresholds."),
    conformance: Path | None = typer.Option(
        None, "--conformance", help="The folder of the renderer's images of scenes/conformance."
    ),
    unproven: bool = typer.Option(False, "--unproven", help="Judge a renderer that has not shown that it conforms."),
    form: Format = typer.Option(Format.HUMAN, "--format", help="How the results are printed."),
    as_json: bool = typer.Option(False, "--json", help="The same as --format json."),
    verbose: bool = VERBOSE,
) -> None:
    """Gates, measure, judge, report."""
    with exit_codes(), reference_errors():
        from vitrail.commands.scene_file import read_scene
        from vitrail.pipeline.score import score as score_images
        from vitrail.report.build import build_report

        loaded = read_scene(scene)
        if candidate is None and views is None:
            raise usage_error("there is no image to judge; name CANDIDATE.exr, or the folder of its --views")
        files = {side: path for side, path in (("candidate", candidate), ("reference", reference)) if path}
        folders = {side: path for side, path in (("candidate", views), ("reference", reference_views)) if path}
        command = ("vitrail", *sys.argv[1:])
        results = score_images(
            loaded,
            files,
            out,
            views=folders,
            references=references,
            conformance=conformance,
            needs_proof=not unproven,
            command=command,
        )
        page = build_report(out)
        print_in(Format.JSON if as_json else form, results, page, [loaded], verbose=verbose)
    raise typer.Exit(results.exit_code)
