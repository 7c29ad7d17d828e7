"""``vitrail bless``: accept images as references. The only way to change one."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from vitrail.commands.comparison_options import load_all, overrides_of, reference_errors
from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.settings_options import QUALITY, SETTINGS
from vitrail.plan.settings import Quality

if TYPE_CHECKING:
    from vitrail.pipeline.accept import Proposal
    from vitrail.scene.load import Loaded


def bless(
    scenes: list[Path] = typer.Argument(None, metavar="SCENE...", help="Scene files, or folders of them."),
    because: str = typer.Option("", "--because", help="Why these images are right; kept with them."),
    source: Path | None = typer.Option(
        None, "--from", help="A finished comparison, or decisions exported by its report."
    ),
    quality: Quality = QUALITY,
    settings: list[str] = SETTINGS,
    references: Path | None = typer.Option(None, "--references", help="The folder that holds the stored images."),
    missing_only: bool = typer.Option(False, "--missing-only", help="Leave scenes alone that have a usable reference."),
    again: bool = typer.Option(False, "--again", help="Render by the recipe that is stored with each reference."),
    dry_run: bool = typer.Option(False, "--dry-run", help="Show what would change, and change nothing."),
) -> None:
    """Render or take each image, show it beside the one it replaces, and store it with its provenance."""
    with exit_codes(), reference_errors():
        if source is None:
            found = _rendered(load_all(scenes or []), because, quality, settings, references, missing_only, again)
        else:
            found = _taken(source, because, references)
        count = 0
        for proposal in found:
            count += 1
            _show(proposal)
            if not dry_run:
                typer.echo(f"  accepted: {proposal.accept()}")
        if count == 0:
            typer.echo("nothing to accept")


def _rendered(
    loaded: list[Loaded],
    because: str,
    quality: Quality,
    settings: list[str],
    references: Path | None,
    missing_only: bool,
    again: bool,
) -> Iterator[Proposal]:
    """Render every scene with the tracer, one after the other."""
    from vitrail.commands.progress_bar import progress_bar
    from vitrail.engines.tracer import Tracer
    from vitrail.judge.reference_files import ReferencesError
    from vitrail.judge.references import references_folder
    from vitrail.pipeline.accept import has_usable, propose_rendering, recipe_of

    overrides = overrides_of(loaded, quality, settings)
    for each in loaded:
        folder = references_folder(each.path, references)
        if missing_only and has_usable(each, folder):
            continue
        reason = because
        if again:
            quality, overrides, older_reason = recipe_of(each, folder)
            reason = because.strip() or older_reason
        with tempfile.TemporaryDirectory(prefix="vitrail-bless-") as work, progress_bar(each.path.stem) as show:
            proposal = propose_rendering(
                each,
                folder,
                reason,
                Path(work),
                engine=Tracer(),
                quality=quality,
                overrides=overrides,
                progress=show,
            )
        if again and not because.strip() and not proposal.is_unchanged:
            raise ReferencesError(
                f"{each.path}: its recipe gives other pixels now; look, and say with --because why they are right"
            )
        yield proposal


def _taken(source: Path, because: str, references: Path | None) -> Iterator[Proposal]:
    """The images of a finished comparison: those that agree with one reason, or those that a reader accepted."""
    from vitrail.commands.scene_file import read_scene
    from vitrail.engines.tracer import Tracer
    from vitrail.judge.references import references_folder
    from vitrail.pipeline.accept import propose_from_run
    from vitrail.pipeline.decisions import read_decisions

    decisions = None if source.is_dir() else read_decisions(source)
    accepted = None if decisions is None else decisions.accepted
    run = source if decisions is None else _run_of(source, decisions.folder)
    for scene in _scenes_of(run):
        if accepted is None and scene["verdict"] != "agrees":
            ending = scene["verdict"] or scene["status"]
            typer.echo(f"{scene['source']}: left out, because it ended as {ending}; decide on it in the report")
            continue
        if accepted is not None and scene["name"] not in accepted:
            continue
        loaded = read_scene(Path(scene["source"]))
        decision = None if accepted is None else accepted[scene["name"]]
        reason = (decision.because if decision else "") or because
        folder = references_folder(loaded.path, references)
        content = decision.content if decision else None
        with tempfile.TemporaryDirectory(prefix="vitrail-bless-") as work:
            yield propose_from_run(loaded, folder, reason, run, scene, content, engine=Tracer(), work=Path(work))


def _run_of(decisions: Path, named: Path) -> Path:
    """The folder of results that decisions are about: where they say, or where they lie."""
    for folder in (decisions.parent, named):
        if (folder / "results.json").is_file():
            return folder
    raise usage_error(f"{decisions}: the results of {named} are not there; put the file into the folder of its results")


def _scenes_of(run: Path) -> list[dict[str, Any]]:
    path = run / "results.json"
    if not path.is_file():
        raise usage_error(f"{run}: holds no results.json; compare the scenes first")
    return list(json.loads(path.read_text(encoding="utf-8"))["scenes"])


def _show(proposal: Proposal) -> None:
    """The scene, the reason, and how each number moves from the old image to the new."""
    typer.echo(f"{proposal.loaded.path}: {proposal.provenance.because}")
    if proposal.is_unchanged:
        typer.echo("  the same pixels as were accepted")
    if proposal.older is None:
        typer.echo(f"  was: {proposal.older_is_unusable}")
        return
    older = proposal.older.provenance
    typer.echo(f"  was: {older.engine} {older.version}, {older.made}, because {older.because}")
    for observed in proposal.changes():
        for entry in observed.measured:
            typer.echo(
                f"  {observed.observation.name}.{entry.metric}: {entry.value:.6g} (unchanged is {entry.ideal:g})"
            )
