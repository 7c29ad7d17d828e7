"""``vitrail tradeoff``: what accuracy costs in each engine, and what modelling only what is required saves."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from vitrail.base.phenomenon import Phenomenon
from vitrail.commands.errors import exit_codes, usage_error
from vitrail.commands.output import print_json
from vitrail.commands.target_error import parse_target_error

if TYPE_CHECKING:
    from vitrail.study.tradeoff.knobs import Extent
    from vitrail.study.tradeoff.plan_records import PlannedScene, Plans
    from vitrail.study.tradeoff.predict import Aim
    from vitrail.study.tradeoff.records import Tradeoff


class ExtentName(StrEnum):
    QUICK = "quick"
    NORMAL = "normal"
    WIDE = "wide"


def tradeoff(
    scenes: list[Path] = typer.Argument(..., metavar="SCENE...", help="Scene files; of several, each has its folder."),
    out: Path = typer.Option(..., "--out", metavar="DIR", help="Folder of the study; call again to resume."),
    extent: ExtentName = typer.Option(ExtentName.NORMAL, "--extent", help="How many settings are tried."),
    plan: bool = typer.Option(False, "--plan", help="Measure what the plan saves, for each scene."),
    analyse_only: bool = typer.Option(False, "--analyse-only", help="Analyse stored samples, render nothing."),
    references: Path | None = typer.Option(None, "--references", help="The folder of closed forms."),
    target_error: list[str] = typer.Option([], "--target-error", metavar="PHENOMENON=ERROR", help="Predict settings."),
    budget_s: float | None = typer.Option(None, "--budget-s", help="Predict settings for so many CPU seconds."),
    jobs: int = typer.Option(1, "--jobs", min=1, help="Tasks at a time."),
    as_json: bool = typer.Option(False, "--json", help="Print the analysis as JSON."),
) -> None:
    with exit_codes():
        if plan:
            plans, page = _plans(scenes, out, jobs, analyse_only)
            record, lines = plans.model_dump(mode="json"), [_plan_line(scene) for scene in plans.scenes]
        elif len(scenes) == 1:
            found, page = _prices(scenes[0], out, extent.value, jobs, references, analyse_only)
            record, lines = found.model_dump(mode="json"), _sentences(found)
            if target_error or budget_s is not None:
                lines += _predictions(scenes[0], out, extent.value, references, found, target_error, budget_s)
        else:
            studies, page = _all_prices(scenes, out, extent.value, jobs, references, analyse_only)
            record = {name: study.model_dump(mode="json") for name, study in studies.items()}
            lines = [f"{name}: {line}" for name, study in studies.items() for line in _sentences(study)]
    if as_json:
        print_json(record)
        return
    for line in [*lines, f"the page is {page}"]:
        typer.echo(line)


def _prices(
    scene: Path, out: Path, extent: Extent, jobs: int, references: Path | None, analyse_only: bool
) -> tuple[Tradeoff, Path]:
    """Errors and costs over the matrix of knobs."""
    from vitrail.commands.progress_bar import progress_bar
    from vitrail.commands.scene_file import read_scene
    from vitrail.report.tradeoff_page import write_tradeoff_page
    from vitrail.study.tradeoff.run import NothingObserved, analyse_folder, run_tradeoff

    loaded = read_scene(scene)
    try:
        if analyse_only:
            found = analyse_folder(loaded, out)
        else:
            with progress_bar("tradeoff") as show:
                found = run_tradeoff(loaded, out, extent=extent, jobs=jobs, references=references, progress=show)
    except NothingObserved as nothing:
        raise usage_error(str(nothing)) from None
    except FileNotFoundError as missing:
        raise _not_run(missing) from None
    return found, write_tradeoff_page(out, found)


def _predictions(
    scene: Path,
    out: Path,
    extent: Extent,
    references: Path | None,
    found: Tradeoff,
    target_error: list[str],
    budget_s: float | None,
) -> list[str]:
    """Settings that the study's model chooses, each with the score of its prediction."""
    from vitrail.commands.progress_bar import progress_bar
    from vitrail.commands.scene_file import read_scene
    from vitrail.report.tradeoff_page import write_tradeoff_page
    from vitrail.study.tradeoff.predict import Aim, predict, prediction_line
    from vitrail.study.tradeoff.run import measure_of

    aims = [_aim(text, found.phenomena) for text in target_error]
    if budget_s is not None:
        aims += [Aim(phenomenon, budget_s=budget_s) for phenomenon in found.phenomena]
    loaded = read_scene(scene)
    measure, _ = measure_of(loaded, out, extent, references)
    with progress_bar("predictions") as show:
        predictions = predict(loaded, out, found, measure, aims, show)
    write_tradeoff_page(out, found, predictions.root)
    return [prediction_line(each) for each in predictions.root]


def _aim(text: str, measured: Iterable[Phenomenon]) -> Aim:
    """``caustic=0.01`` as an aim."""
    from vitrail.study.tradeoff.predict import Aim

    phenomenon, metric, wanted = parse_target_error(text, measured, "the study measured", "name one of them")
    if metric:
        raise usage_error(f"--target-error {text}: a study predicts whole phenomena; write {phenomenon}={wanted:g}")
    return Aim(Phenomenon(phenomenon), error=wanted)


def _all_prices(
    scenes: list[Path], out: Path, extent: Extent, jobs: int, references: Path | None, analyse_only: bool
) -> tuple[dict[str, Tradeoff], Path]:
    """One study a scene, each in a folder of its name, and a page over all of them."""
    from vitrail.report.tradeoff_page import write_prices_page

    names = [scene.stem for scene in scenes]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice:
        raise usage_error(f"two scenes are called {twice}, and their studies would share a folder; run them apart")
    found = {
        scene.stem: _prices(scene, out / scene.stem, extent, jobs, references, analyse_only)[0] for scene in scenes
    }
    return found, write_prices_page(out, found)


def _sentences(found: Tradeoff) -> list[str]:
    return [entry.sentence for entry in found.phenomena.values()]


def _plans(scenes: list[Path], out: Path, jobs: int, analyse_only: bool) -> tuple[Plans, Path]:
    """Everything on, the plan, and the plan less one phenomenon at a time."""
    from vitrail.commands.progress_bar import progress_bar
    from vitrail.commands.scene_file import read_scene
    from vitrail.report.plans_page import write_plans_page
    from vitrail.study.tradeoff.plan_study import analyse_plan_folder, run_plan_study

    loaded = [read_scene(scene) for scene in scenes]
    if analyse_only:
        try:
            found = analyse_plan_folder(out)
        except FileNotFoundError as missing:
            raise _not_run(missing) from None
    else:
        with progress_bar("plans") as show:
            found = run_plan_study(loaded, out, jobs=jobs, progress=show)
    return found, write_plans_page(out, found)


def _not_run(missing: FileNotFoundError) -> Exception:
    return usage_error(f"{missing.filename}: no such file; run the study first, without --analyse-only")


def _plan_line(scene: PlannedScene) -> str:
    """One scene of the table in a sentence."""
    if scene.failure:
        return f"{scene.name}: {scene.failure}"
    whole, seconds = scene.differences["everything"], scene.cpu_s
    same = "the same bits" if whole.same_bits else f"{whole.relative_l1:.2g} apart"
    return f"{scene.name}: {seconds['plan']:.2f} s instead of {seconds['everything']:.2f} s, {same}"
