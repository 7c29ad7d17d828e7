"""``vitrail render``: one scene, one engine, one image with its run record beside it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from vitrail.base.engine_name import EngineName
from vitrail.base.exit_code import ExitCode
from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.output import print_json
from vitrail.commands.render_passes import (
    BUDGET_S,
    PASSES,
    RESUME,
    TARGET_ERROR,
    PassOptions,
    render_passes,
    say_how_it_ended,
)
from vitrail.commands.settings_options import QUALITY, SETTINGS, prepared
from vitrail.plan.settings import Quality, Solver

if TYPE_CHECKING:
    from vitrail.engines.base import Rendering
    from vitrail.pipeline.job import Job


def render(
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    out: Path = typer.Option(..., "--out", metavar="FILE.exr", help="The image to write."),
    engine: EngineName = typer.Option(EngineName.TRACER, "--engine", help="The engine to render with."),
    quality: Quality = QUALITY,
    samples: int | None = typer.Option(None, "--samples", help="Samples per pixel."),
    photons: int | None = typer.Option(None, "--photons", help="Photons of the whole scene."),
    seed: int | None = typer.Option(None, "--seed", help="Seed of the random numbers."),
    threads: int = typer.Option(0, "--threads", min=0, help="Threads; 0 takes every core."),
    solver: Solver = typer.Option(Solver.AUTO, "--solver", help="How caustics are solved."),
    settings: list[str] = SETTINGS,
    passes: int | None = PASSES,
    budget_s: float | None = BUDGET_S,
    target_error: list[str] = TARGET_ERROR,
    resume: bool = RESUME,
    png: bool = typer.Option(False, "--png", help="Write a picture for the eye beside the image."),
    as_json: bool = typer.Option(False, "--json", help="Print the run record as JSON."),
) -> None:
    """Render a scene; the run record is written beside the image as FILE.run.json."""
    with exit_codes():
        if out.suffix != ".exr":
            raise usage_error(f"--out {out}: the image is an EXR file; end its name with .exr")
        from vitrail.commands.scene_file import read_scene

        options = {"samples": samples, "photons": photons, "seed": seed, "solver": solver}
        job = prepared(read_scene(scene), quality, settings, **options)
        for warning in job.plan.warnings:
            typer.echo(f"warning: {warning}", err=True)
        given = samples is not None or any(each.split("=")[0].strip() == "samples" for each in settings)
        by_passes = PassOptions(passes, budget_s, target_error, resume, given)
        if by_passes.wanted:
            _by_passes(engine, job, threads, out, by_passes, png, as_json)
            return
        made = _rendered(engine, job, threads, out)
        _say_files(made.record, out, job, png, as_json)
        if made.interrupted:
            typer.echo("interrupted: the image holds the finished work", err=True)
            raise typer.Exit(ExitCode.INTERRUPTED)


def _by_passes(
    engine: EngineName, job: Job, threads: int, out: Path, options: PassOptions, png: bool, as_json: bool
) -> None:
    """Render by passes, say what came of it, and end with its exit code."""
    if engine is not EngineName.TRACER:
        raise usage_error("--engine povray: only the tracer renders by passes; leave --engine out, or those options")
    done, code = render_passes(job, threads, out, options)
    if done.record is not None:
        _say_files(done.record, out, job, png, as_json)
    say_how_it_ended(done, code)
    if code:
        raise typer.Exit(code)


def _say_files(record: dict[str, Any], out: Path, job: Job, png: bool, as_json: bool) -> None:
    for warning in record.get("warnings", ()):
        typer.echo(f"warning: {warning}", err=True)
    files = [out, out.with_suffix(".run.json")] + ([_picture(out, job)] if png else [])
    print_json(record) if as_json else typer.echo("\n".join(str(file) for file in files))


def _rendered(engine: EngineName, job: Job, threads: int, out: Path) -> Rendering:
    """The image and its record in their places, with a bar that shows how far it is."""
    from vitrail.commands.progress_bar import progress_bar
    from vitrail.engines.installed import engine_named
    from vitrail.pipeline.render_image import render_image

    with progress_bar(out.stem) as show:
        return render_image(job, engine_named(engine), out, threads=threads, progress=show)


def _picture(out: Path, job: Job) -> Path:
    """The image as a PNG, through the one display transform of the project."""
    from vitrail.images.display import Display
    from vitrail.images.exr import read_image, write_png

    picture = out.with_suffix(".png")
    write_png(picture, Display(job.scene.image.exposure_stops).apply(read_image(out).radiance))
    return picture
