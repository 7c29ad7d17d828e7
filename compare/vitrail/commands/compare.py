"""``vitrail compare``: scenes through both engines, verdicts, a report."""

from __future__ import annotations

import sys
from enum import StrEnum
from pathlib import Path

import typer

from vitrail.base.exit_code import ExitCode
from vitrail.commands.comparison_options import defect_named, load_all, overrides_of, reference_errors, watching
from vitrail.commands.errors import exit_codes
from vitrail.commands.result_formats import VERBOSE, Format, print_in
from vitrail.commands.settings_options import QUALITY, SETTINGS
from vitrail.plan.settings import Quality


class Against(StrEnum):
    """POV-Ray, the tracer's own stored image, or both; closed forms always, and with ``truth`` nothing else."""

    TRUTH = "truth"
    POVRAY = "povray"
    STORED = "stored"
    BOTH = "both"

    @property
    def sides(self) -> tuple[str, ...]:
        return {
            Against.TRUTH: (),
            Against.POVRAY: ("povray",),
            Against.STORED: ("stored",),
            Against.BOTH: ("povray", "stored"),
        }[self]


def compare(
    scenes: list[Path] = typer.Argument(..., metavar="SCENE...", help="Scene files, or folders of them."),
    out: Path = typer.Option(..., "--out", help="The folder for report, results and images."),
    quality: Quality = QUALITY,
    settings: list[str] = SETTINGS,
    threads: int = typer.Option(0, "--threads", min=0, help="Threads of an engine; 0 takes every core."),
    jobs: int = typer.Option(1, "--jobs", min=1, help="Scenes worked on at a time."),
    against: Against = typer.Option(Against.POVRAY, "--against", help="What the tracer is held against."),
    views: bool = typer.Option(True, "--views/--no-views", help="Measure each observation in a picture of its own."),
    picture_width: int | None = typer.Option(
        None, "--picture-width", min=1, help="Pixels across the scene's own picture at least; 480 if not given."
    ),
    rounds: int = typer.Option(1, "--rounds", min=0, help="How often to buy more samples for a scene in doubt."),
    budget_s: float | None = typer.Option(None, "--budget-s", min=0, help="CPU seconds for all that is in doubt."),
    references: Path | None = typer.Option(None, "--references", help="The folder of closed forms and thresholds."),
    inject_defect: str = typer.Option("", "--inject-defect", help="Put a known mistake in, to see it caught."),
    form: Format = typer.Option(Format.HUMAN, "--format", help="How the results are printed."),
    as_json: bool = typer.Option(False, "--json", help="The same as --format json."),
    verbose: bool = VERBOSE,
    allow_open: bool = typer.Option(
        False, "--allow-open", help="End with 0 where nothing deviates or fails, though some bounds are too wide."
    ),
) -> None:
    """Load, plan, lower, render, measure, judge, report."""
    with exit_codes(), reference_errors():
        from vitrail.pipeline.compare import compare as compare_scenes
        from vitrail.pipeline.request import Request
        from vitrail.plan.views import PICTURE_WIDTH
        from vitrail.report.build import build_report

        loaded = load_all(scenes)
        request = Request(
            out=out,
            overrides=overrides_of(loaded, quality, settings),
            quality=quality,
            threads=threads,
            jobs=jobs,
            views=views,
            picture_width=picture_width or PICTURE_WIDTH,
            rounds=rounds,
            budget_s=budget_s,
            against=against.sides,
            references=references,
            defect=defect_named(inject_defect),
            command=("vitrail", *sys.argv[1:]),
        )
        with watching(len(loaded), verbose=verbose) as show:
            results = compare_scenes(loaded, request, show)
        page = build_report(out)
        print_in(Format.JSON if as_json else form, results, page, loaded, verbose=verbose)
        if results.exit_code == ExitCode.INTERRUPTED:
            done = f"{len(results.scenes)} of {len(loaded)} scenes are finished and kept"
            typer.echo(f"interrupted: {done} in {out / 'results.json'}; run it again for the rest", err=True)
    is_open = results.exit_code == ExitCode.INCONCLUSIVE
    raise typer.Exit(ExitCode.AGREES if allow_open and is_open else results.exit_code)
