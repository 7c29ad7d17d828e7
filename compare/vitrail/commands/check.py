"""``vitrail check``: what is wrong with a scene, before anything is rendered."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import typer

from vitrail.base.exit_code import ExitCode
from vitrail.commands.output import print_json


def check(
    scenes: list[Path] = typer.Argument(..., metavar="SCENE...", help="Scene files."),
    as_json: bool = typer.Option(False, "--json", help="Print the diagnostics as JSON."),
) -> None:
    reports = [_report(path) for path in scenes]
    if as_json:
        print_json(reports)
    else:
        for report in reports:
            _say(report)
    if any(report["errors"] for report in reports):
        raise typer.Exit(ExitCode.SCENE_ERROR)


def _report(path: Path) -> dict[str, Any]:
    """Errors and warnings of one file."""
    from vitrail.commands.scene_file import read_and_check
    from vitrail.scene.diagnostic import SceneErrors

    try:
        loaded, warnings = read_and_check(path)
    except SceneErrors as errors:
        return {"scene": str(path), "errors": [_as_json(each) for each in errors.diagnostics], "warnings": []}
    summary = f"objects: {len(loaded.scene.objects)}, lights: {len(loaded.scene.lights)}"
    return {"scene": str(path), "errors": [], "warnings": [_as_json(each) for each in warnings], "summary": summary}


def _as_json(diagnostic: Any) -> dict[str, Any]:
    names = ("file", "line", "col", "what", "remedy")
    return {**{name: getattr(diagnostic, name) for name in names}, "message": str(diagnostic)}


def _say(report: dict[str, Any]) -> None:
    for diagnostic in (*report["errors"], *report["warnings"]):
        typer.echo(diagnostic["message"], err=True)
    if not report["errors"]:
        typer.echo(f"{report['scene']}: good ({report['summary']})")
