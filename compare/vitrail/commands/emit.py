"""``vitrail emit``: the input of one engine, as files."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, assert_never

import typer

from vitrail.base.whole_file import write_whole
from vitrail.commands.exit_code import exit_codes
from vitrail.commands.output import print_json
from vitrail.commands.settings_options import QUALITY, SETTINGS, parse_settings
from vitrail.plan.settings import Quality

if TYPE_CHECKING:
    import numpy as np


class EngineName(StrEnum):
    TRACER = "tracer"
    POVRAY = "povray"


def emit(
    engine: EngineName = typer.Argument(..., help="The engine to write for."),
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    out: Path = typer.Option(..., "--out", help="The folder to write into."),
    quality: Quality = QUALITY,
    settings: list[str] = SETTINGS,
    as_json: bool = typer.Option(False, "--json", help="Print the names of the files as JSON."),
) -> None:
    with exit_codes():
        from vitrail.engines.povray_result import write_sky

        files = emitted(engine, scene, quality, settings)
        for name, content in files.items():
            if isinstance(content, str):
                write_whole(out / name, content)
            else:
                write_sky(out / name, content)
    names = [str(out / name) for name in files]
    print_json({"files": names}) if as_json else typer.echo("\n".join(names))


def emitted(engine: EngineName, path: Path, quality: Quality, assignments: list[str]) -> dict[str, str | np.ndarray]:
    """File name to text, or to the pixels of a sky; all made before the first is written."""
    from vitrail.base.canonical_json import canonical_json
    from vitrail.commands.scene_file import read_scene
    from vitrail.geometry.world import World
    from vitrail.lower.tracer import lower_tracer
    from vitrail.plan.analyse import analyse

    world = World.of(read_scene(path))
    found = analyse(world)
    chosen = parse_settings(world, found, quality, assignments)
    match engine:
        case EngineName.TRACER:
            return {"scene.json": canonical_json(lower_tracer(world, found, chosen))}
        case EngineName.POVRAY:
            from vitrail.lower.povray import lower_povray

            translated = lower_povray(world, found, chosen)
            certificate = canonical_json(translated.certificate.as_records())
            scenes = {name: text for run in translated.runs for name, text in run.texts.items()}
            skies = {run.sky.name: run.sky.pixels for run in translated.runs if run.sky is not None}
            return {**scenes, **skies, "certificate.json": certificate}
        case _:
            assert_never(engine)
