"""``vitrail emit``: the input of one engine, or of any renderer for the views of a scene, as files."""

from __future__ import annotations

from enum import StrEnum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, assert_never

import typer

from vitrail.base.engine_name import EngineName
from vitrail.base.whole_file import write_whole
from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.output import print_json
from vitrail.commands.settings_options import QUALITY, SETTINGS, prepared
from vitrail.plan.settings import Quality

if TYPE_CHECKING:
    import numpy as np


class Target(StrEnum):
    """Whom the files are for: one of our engines, or any renderer that makes the views."""

    TRACER = "tracer"
    POVRAY = "povray"
    VIEWS = "views"


def emit(
    target: Target = typer.Argument(..., help="The engine to write for, or `views` for any renderer."),
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    out: Path = typer.Option(..., "--out", help="The folder to write into."),
    quality: Quality = QUALITY,
    settings: list[str] = SETTINGS,
    readable: bool = typer.Option(
        False, "--readable", help="For POV-Ray: one commented file to render and edit, less exact than the runs."
    ),
    as_json: bool = typer.Option(False, "--json", help="Print the names of the files as JSON."),
) -> None:
    with exit_codes():
        from vitrail.engines.povray_result import write_sky

        if readable and target is not Target.POVRAY:
            raise usage_error("--readable writes for POV-Ray; use `vitrail emit povray --readable`")
        make = emitted_readable if readable else partial(emitted, target)
        files = make(scene, quality, settings)
        for name, content in files.items():
            if isinstance(content, str):
                write_whole(out / name, content)
            else:
                write_sky(out / name, content)
    names = [str(out / name) for name in files]
    print_json({"files": names}) if as_json else typer.echo("\n".join(names))


def emitted_readable(path: Path, quality: Quality, assignments: list[str]) -> dict[str, str | np.ndarray]:
    """The same for a person: the scene in one file, with what it includes, and what it only approximates."""
    from vitrail.base.canonical_json import canonical_json
    from vitrail.commands.scene_file import read_scene
    from vitrail.lower.povray import lower_readable

    job = prepared(read_scene(path), quality, assignments)
    made = lower_readable(job.world, job.plan, job.settings, path.name)
    return {**made.files, **made.skies, "certificate.json": canonical_json(made.certificate.as_json())}


def emitted(target: Target, path: Path, quality: Quality, assignments: list[str]) -> dict[str, str | np.ndarray]:
    """File name to text, or to the pixels of a sky; all made before the first is written."""
    from vitrail.base.canonical_json import canonical_json
    from vitrail.commands.scene_file import read_scene

    job = prepared(read_scene(path), quality, assignments)
    match target:
        case Target.VIEWS:
            from vitrail.pipeline.foreign_views import emitted_views

            return dict(emitted_views(job))
        case Target.TRACER:
            return {"scene.json": canonical_json(job.lowered(EngineName.TRACER))}
        case Target.POVRAY:
            translated = job.lowered(EngineName.POVRAY)
            certificate = canonical_json(translated.certificate.as_json())
            scenes = {name: text for run in translated.runs for name, text in run.texts.items()}
            skies = {run.sky.name: run.sky.pixels for run in translated.runs if run.sky is not None}
            return {**scenes, **skies, "certificate.json": certificate}
        case _:
            assert_never(target)
