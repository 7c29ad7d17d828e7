"""``vitrail tradeoff``: what accuracy costs in each engine, and what modelling only what is required saves."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from vitrail.commands.exit_code import exit_codes, usage_error
from vitrail.commands.output import print_json

if TYPE_CHECKING:
    from vitrail.study.tradeoff.knobs import Extent


class ExtentName(StrEnum):
    QUICK = "quick"
    NORMAL = "normal"
    WIDE = "wide"


def tradeoff(
    scenes: list[Path] = typer.Argument(..., metavar="SCENE...", help="Scene files; one, unless --plan is given."),
    out: Path = typer.Option(..., "--out", metavar="DIR", help="Folder of the study; call again to resume."),
    extent: ExtentName = typer.Option(ExtentName.NORMAL, "--extent", help="How many settings are tried."),
    plan: bool = typer.Option(False, "--plan", help="Measure what the plan saves, for each scene."),
    analyse_only: bool = typer.Option(False, "--analyse-only", help="Analyse stored samples, render nothing."),
    references: Path | None = typer.Option(None, "--references", help="The folder of closed forms."),
    jobs: int = typer.Option(1, "--jobs", min=1, help="Tasks at a time."),
    as_json: bool = typer.Option(False, "--json", help="Print the analysis as JSON."),
) -> None:
    with exit_codes():
        if len(scenes) > 1 and not plan:
            raise usage_error("give one scene, or --plan for a table over several")
        if plan:
            found, page = _plans(scenes, out, jobs)
            lines = [_plan_line(scene) for scene in found["scenes"]]
        else:
            found, page = _prices(scenes[0], out, extent.value, jobs, references, analyse_only)
            lines = [entry["sentence"] for entry in found["phenomena"].values()]
    if as_json:
        print_json(found)
        return
    for line in [*lines, f"the page is {page}"]:
        typer.echo(line)


def _prices(
    scene: Path, out: Path, extent: Extent, jobs: int, references: Path | None, analyse_only: bool
) -> tuple[dict, Path]:
    """Errors and costs over the matrix of knobs."""
    from vitrail.commands.scene_file import read_scene
    from vitrail.commands.study_options import study_progress
    from vitrail.report.tradeoff_page import write_tradeoff_page
    from vitrail.study.tradeoff.run import NoTruth, analyse_folder, run_tradeoff

    loaded = read_scene(scene)
    try:
        if analyse_only:
            found = analyse_folder(loaded, out)
        else:
            with study_progress("tradeoff") as report:
                found = run_tradeoff(loaded, out, extent=extent, jobs=jobs, references=references, report=report)
    except NoTruth as nothing:
        raise usage_error(str(nothing)) from None
    except FileNotFoundError as missing:
        raise usage_error(f"{missing.filename}: no such file; run the study first, without --analyse-only") from None
    return found, write_tradeoff_page(out, found)


def _plans(scenes: list[Path], out: Path, jobs: int) -> tuple[dict, Path]:
    """Everything on, the plan, and the plan less one phenomenon at a time."""
    from vitrail.commands.scene_file import read_scene
    from vitrail.commands.study_options import study_progress
    from vitrail.report.tradeoff_page import write_plans_page
    from vitrail.study.tradeoff.plan_study import run_plan_study

    loaded = [read_scene(scene) for scene in scenes]
    with study_progress("plans") as report:
        found = run_plan_study(loaded, out, jobs=jobs, report=report)
    return found, write_plans_page(out, found)


def _plan_line(scene: dict) -> str:
    """One scene of the table in a sentence."""
    if scene["failure"]:
        return f"{scene['name']}: {scene['failure']}"
    whole, seconds = scene["differences"]["everything"], scene["cpu_s"]
    same = "the same bits" if whole["same_bits"] else f"{whole['relative_l1']:.2g} apart"
    return f"{scene['name']}: {seconds['plan']:.2f} s instead of {seconds['everything']:.2f} s, {same}"
