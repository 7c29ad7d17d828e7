"""``vitrail extremes``: walk every axis in both engines and draw the stability atlas."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.output import print_json

if TYPE_CHECKING:
    from vitrail.study.extremes.records import EngineRange


def extremes(
    out: Path = typer.Option(..., "--out", metavar="DIR", help="Folder of the study; call again to resume."),
    axis: list[str] = typer.Option([], "--axis", help="Only this axis; may be given several times."),
    jobs: int = typer.Option(1, "--jobs", min=1, help="Tasks at a time."),
    scenes_only: bool = typer.Option(
        False, "--scenes-only", help="Measure nothing: write the failing scenes of the finished atlas in --out again."
    ),
    as_json: bool = typer.Option(False, "--json", help="Print the atlas as JSON."),
) -> None:
    with exit_codes():
        from vitrail.commands.progress_bar import progress_bar
        from vitrail.report.atlas_page import write_atlas_page, write_atlas_text
        from vitrail.study.extremes.atlas import AXES, run_atlas

        if scenes_only:
            typer.echo(f"the scenes are in {_scenes_of(out)}")
            return
        names = [known.name for known in AXES]
        unknown = [name for name in axis if name not in names]
        if unknown:
            raise usage_error(f"--axis {unknown[0]}: there is no such axis; choose from {', '.join(names)}")
        chosen = [known for known in AXES if not axis or known.name in axis]
        with progress_bar("extremes") as show:
            atlas = run_atlas(out, jobs=jobs, axes=chosen, progress=show)
        page = write_atlas_page(out, atlas)
        write_atlas_text(out, atlas)
    if as_json:
        print_json(atlas.model_dump(mode="json"))
        return
    for record in atlas.axes:
        typer.echo(f"{record.name}: {record.quantity} ({record.unit})")
        for engine, found in record.engines.items():
            typer.echo(f"  {engine:8} {_words(found)}")
    typer.echo(f"the atlas is {page}")


def _scenes_of(out: Path) -> Path:
    """Write the scenes that fail by the atlas in ``out``; returns their folder."""
    from vitrail.base.record import read_record
    from vitrail.study.extremes.atlas import write_scenes
    from vitrail.study.extremes.records import Atlas

    try:
        write_scenes(out / "scenes", read_record(Atlas, out / "atlas.json"))
    except FileNotFoundError as missing:
        raise usage_error(f"{missing.filename}: no such file; run the study first, without --scenes-only") from None
    return out / "scenes"


def _words(found: EngineRange) -> str:
    """One engine's range in a sentence."""
    if found.failure:
        return f"not measured: {found.failure}"
    if found.first_failing is None:
        return f"holds to {found.last_holding:.3g}, the last value tried"
    why = f" ({found.limit})" if found.limit else ""
    return f"fails from {found.first_failing:.3g}{why}"
