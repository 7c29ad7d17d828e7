"""``vitrail trace``: follow one ray through a scene and print each vertex."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Any

import typer

from vitrail.base.engine_name import EngineName
from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.output import print_json, wide_console


class Branch(StrEnum):
    """Which way to follow where a face both mirrors and transmits."""

    TRANSMIT = "transmit"
    REFLECT = "reflect"


def trace(
    scene: Path = typer.Argument(..., metavar="SCENE", help="A scene file."),
    origin: str = typer.Option(..., "--origin", metavar="X,Y,Z", help="Where the ray starts, metres."),
    direction: str = typer.Option(..., "--direction", metavar="X,Y,Z", help="Where it goes; any length."),
    band: int | None = typer.Option(None, "--band", min=0, help="The band of the light, from 0."),
    wavelength_nm: float | None = typer.Option(None, "--wavelength-nm", min=1.0, help="Or its wavelength."),
    branch: Branch = typer.Option(Branch.TRANSMIT, "--branch", help="Which way to follow where light splits."),
    max_vertices: int = typer.Option(64, "--max-vertices", min=1, help="Stop after so many faces."),
    as_json: bool = typer.Option(False, "--json", help="Print the vertices as JSON."),
) -> None:
    with exit_codes():
        start, way = _numbers("--origin", origin), _numbers("--direction", direction)
        if not any(way):
            raise usage_error(f"--direction {direction}: the zero vector has no direction")
        if band is not None and wavelength_nm is not None:
            raise usage_error("--band and --wavelength-nm both choose the light; give one of them")
        arguments = ["--origin", _words(start), "--direction", _words(way), "--branch", branch.value]
        arguments += ["--max-vertices", str(max_vertices)]
        answer = _traced(scene, band, wavelength_nm, arguments)
    print_json(answer) if as_json else _print_vertices(answer["vertices"])


def _traced(path: Path, band: int | None, wavelength_nm: float | None, arguments: list[str]) -> dict[str, Any]:
    """Lower the scene with everything on, so that a ray meets what no camera ray of the scene would, and follow it."""
    from vitrail.commands.scene_file import read_scene
    from vitrail.engines.tracer import Tracer
    from vitrail.pipeline.job import prepare
    from vitrail.plan.analyse import everything
    from vitrail.plan.settings import Quality

    job = prepare(read_scene(path), Quality.DRAFT, planner=everything)
    lowered = job.lowered(EngineName.TRACER, wavelength_nm=wavelength_nm)
    if band is not None and band >= len(lowered["bands"]):
        raise usage_error(f"--band {band}: the scene has {len(lowered['bands'])} band(s), counted from 0")
    chosen = ["--band", str(band or 0)] if band is not None or wavelength_nm is not None else []
    return Tracer().trace(lowered, [*arguments, *chosen])


def _numbers(option: str, text: str) -> tuple[float, float, float]:
    """Three finite numbers with commas between them."""
    import math

    try:
        x, y, z = (float(part) for part in text.split(","))
    except ValueError:
        raise usage_error(f"{option} {text}: write three numbers with commas, for example 0,1,0") from None
    if not all(math.isfinite(value) for value in (x, y, z)):
        raise usage_error(f"{option} {text}: write finite numbers")
    return (x, y, z)


def _words(vector: tuple[float, float, float]) -> str:
    return ",".join(repr(value) for value in vector)


def _print_vertices(vertices: list[dict[str, Any]]) -> None:
    from rich.table import Table

    table = Table()
    columns = ("point", "object", "event", "medium", "direction_out", "throughput", "R", "T")
    for column in columns:
        table.add_column(column, overflow="fold")
    for vertex in vertices:
        table.add_row(*(_cell(vertex.get(column)) for column in columns))
    wide_console().print(table)


def _cell(value: Any) -> str:
    match value:
        case None:
            return ""
        case float():
            return f"{value:.9g}"
        case list():
            return " ".join(f"{part:.9g}" for part in value)
        case _:
            return str(value)
