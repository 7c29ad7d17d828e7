"""``vitrail mutants``: inject known defects and show which of them the verdicts catch, and by what name."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from vitrail.base.exit_code import ExitCode
from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.output import print_json

if TYPE_CHECKING:
    from vitrail.study.mutants.records import MutantEntry, Mutants


def mutants(
    scenes: Path = typer.Option(Path("scenes"), "--scenes", help="The folder of calibration and conformance."),
    out: Path = typer.Option(Path("out/mutants"), "--out", metavar="DIR", help="Folder of the study; call to resume."),
    only: list[str] = typer.Option([], "--only", help="Only this mutant; may be given several times."),
    jobs: int = typer.Option(1, "--jobs", min=1, help="Mutants worked on at a time."),
    equal_runs: int = typer.Option(
        0, "--equal-runs", min=0, help="Instead: so many pairs that differ in the seed alone."
    ),
    publish: Path | None = typer.Option(
        None, "--publish", metavar="DIR", help="Besides measure limits and equal runs, and write page and data there."
    ),
    limits: bool = typer.Option(False, "--limits", help="Instead: the smallest defects that must be seen, and halves."),
    as_json: bool = typer.Option(False, "--json", help="Print the matrix as JSON."),
) -> None:
    """Exit code 1 when a mutant escapes."""
    if limits:
        _limits(scenes / "calibration", out, as_json)
        return
    if equal_runs:
        _equal_runs(scenes / "calibration" / "ball_lens.yaml", out, equal_runs, as_json)
        return
    with exit_codes():
        from vitrail.commands.progress_bar import progress_bar
        from vitrail.report.mutants_page import write_mutants_page
        from vitrail.study.mutants.catalogue import MUTANTS
        from vitrail.study.mutants.run import run_mutants

        names = [known.name for known in MUTANTS]
        unknown = [name for name in only if name not in names]
        if unknown:
            raise usage_error(f"--only {unknown[0]}: there is no such mutant; choose from {', '.join(names)}")
        chosen = [known for known in MUTANTS if not only or known.name in only]
        with progress_bar("mutants") as show:
            found = run_mutants(scenes, out, mutants=chosen, jobs=jobs, progress=show)
        page = write_mutants_page(out, found)
        if publish is not None:
            page = _publish(scenes / "calibration", out, publish, found)
    if as_json:
        print_json(found.model_dump(mode="json"))
    else:
        for entry in found.mutants:
            typer.echo(_words(entry))
        total = len(found.mutants)
        typer.echo(f"{found.caught} of {total} caught, {found.named} named right; the page is {page}")
    raise typer.Exit(0 if found.caught == len(found.mutants) else ExitCode.DEVIATES)


def _publish(bench: Path, out: Path, target: Path, found: Mutants) -> Path:
    """The page and its data, with the limits and the false alarms beside the matrix."""
    from vitrail.engines.tracer import Tracer
    from vitrail.report.mutants_text import write_mutants_text
    from vitrail.scene.load import load
    from vitrail.study.equal_runs import equal_runs
    from vitrail.study.mutants.limits import measure_limits

    limits = measure_limits(bench, out)
    equal = equal_runs(load(bench / "ball_lens.yaml"), out / "equal", Tracer(), overrides={})
    return write_mutants_text(target, found, limits, equal)


def _equal_runs(scene: Path, out: Path, pairs: int, as_json: bool) -> None:
    """Count the false alarms between runs that are equal but for the seed; exit code 1 when the rate is not kept."""
    with exit_codes():
        from vitrail.commands.progress_bar import progress_bar
        from vitrail.commands.scene_file import read_scene
        from vitrail.engines.tracer import Tracer
        from vitrail.study.equal_runs import equal_runs

        with progress_bar("equal runs") as show:
            found = equal_runs(read_scene(scene), out / "equal", Tracer(), pairs=pairs, overrides={}, progress=show)
    if as_json:
        print_json(found.model_dump(mode="json"))
    for row in [] if as_json else found.rates:
        typer.echo(
            f"at a rate of {100 * row.rate:g} %: {row.alarms} of {row.suites} suites raise a false alarm"
            f" (chance of as many: {row.p_value:.2g})"
        )
    if found.failures or any(row.p_value < 0.01 for row in found.rates):
        raise typer.Exit(ExitCode.DEVIATES)


def _limits(bench: Path, out: Path, as_json: bool) -> None:
    """Judge the smallest defects that must be seen; exit code 1 when one is not, or when half of one passes."""
    with exit_codes():
        from vitrail.report.mutants_text import limits_table
        from vitrail.study.mutants.limits import measure_limits

        found = measure_limits(bench, out)
    if as_json:
        print_json(found.model_dump(mode="json"))
    else:
        typer.echo(limits_table(found), nl=False)
    raise typer.Exit(0 if found.kept else ExitCode.DEVIATES)


def _words(entry: MutantEntry) -> str:
    """One mutant in a line."""
    if entry.failure:
        return f"{entry.name}: {entry.failure}"
    seen = entry.reported or "nothing"
    return f"{entry.name} ({entry.injected}, {entry.injected_engine}): reported {seen}, {entry.engine}"
