"""``vitrail compare``: scenes through both engines, verdicts, a report."""

from __future__ import annotations

import sys
from enum import StrEnum
from pathlib import Path

import typer

from vitrail.commands.comparison_options import defect_named, load_all, overrides_of, reference_errors, watching
from vitrail.commands.exit_code import exit_codes
from vitrail.commands.output import print_json
from vitrail.commands.settings_options import QUALITY, SETTINGS


class Against(StrEnum):
    """POV-Ray, the tracer's own stored image, or both; closed forms always."""

    POVRAY = "povray"
    STORED = "stored"
    BOTH = "both"

    @property
    def sides(self) -> tuple[str, ...]:
        return ("povray", "stored") if self is Against.BOTH else (self.value,)


def compare(
    scenes: list[Path] = typer.Argument(..., metavar="SCENE...", help="Scene files, or folders of them."),
    out: Path = typer.Option(..., "--out", help="The folder for report, results and images."),
    quality: str = QUALITY,
    settings: list[str] = SETTINGS,
    threads: int = typer.Option(0, "--threads", min=0, help="Threads of an engine; 0 takes every core."),
    jobs: int = typer.Option(1, "--jobs", min=1, help="Scenes worked on at a time."),
    against: Against = typer.Option(Against.POVRAY, "--against", help="What the tracer is held against."),
    rounds: int = typer.Option(
        1, "--rounds", min=0, help="How often to buy up to 16 times the samples where in doubt."
    ),
    references: Path | None = typer.Option(None, "--references", help="The folder of closed forms and thresholds."),
    inject_defect: str = typer.Option("", "--inject-defect", help="Put a known mistake in, to see it caught."),
    as_json: bool = typer.Option(False, "--json", help="Print results.json instead of the table."),
) -> None:
    """Load, plan, lower, render, measure, judge, report."""
    with exit_codes(), reference_errors():
        from vitrail.commands.verdict_table import print_results
        from vitrail.report.build import build_report
        from vitrail.study.compare.request import Request
        from vitrail.study.compare.suite import compare as compare_scenes

        loaded = load_all(scenes)
        request = Request(
            out=out,
            overrides=overrides_of(loaded, quality, settings),
            quality=quality,  # type: ignore[arg-type]
            threads=threads,
            jobs=jobs,
            rounds=rounds,
            against=against.sides,
            references=references,
            defect=defect_named(inject_defect),
            command=("vitrail", *sys.argv[1:]),
        )
        with watching(len(loaded)) as watch:
            results = compare_scenes(loaded, request, watch)
        page = build_report(out)
        if as_json:
            print_json(results.model_dump(mode="json"))
        else:
            print_results(results, page)
    raise typer.Exit(results.exit_code)
