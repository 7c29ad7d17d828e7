"""What a person reads in the terminal after a comparison: one line per scene, then what went wrong and where."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from vitrail.commands.comparison_sentence import sentence, where

if TYPE_CHECKING:
    from vitrail.judge.comparison import Comparison, ObservationResult
    from vitrail.judge.records import Results, SceneResult

COLOURS = {"agrees": "green", "deviates": "red", "inconclusive": "yellow"}


def print_results(results: Results, page: Path | None) -> None:
    """The table of scenes, the comparisons that need attention, and the report's place."""
    console = Console(soft_wrap=True)
    console.print(_table(results))
    for scene in results.scenes:
        for line in attention(scene):
            console.print(line)
    shared = results.false_alarms
    console.print(
        f"{shared.comparisons} comparisons; a clean run alarms in at most {100 * shared.suite_rate:g} % of cases"
    )
    if page is not None:
        console.print(f"report: {page}")


def attention(scene: SceneResult) -> list[str]:
    """What, by how much, and the line to make it again; of a scene that agrees only what must be remarked on."""
    lines = [f"[red]{escape(scene.name)}[/]: {escape(scene.message)}"] if scene.message else []
    for observation in scene.observations:
        if observation.verdict.value == "agrees":
            continue
        for comparison in observation.comparisons:
            if comparison.verdict is observation.verdict:
                lines.append(_line(scene, observation, comparison))
        lines += [f"  {escape(line)}" for line in where(observation)]
        lines += [f"  not measured: {escape(reason)}" for reason in observation.unmeasured]
    if scene.more_samples is not None:
        lines.append(f"  undecided: {escape(scene.more_samples.reason)}; --budget-s bounds it")
    if lines and scene.reproduce:
        lines.append(f"  again: {escape(scene.reproduce)}")
    return lines + [f"[yellow]{escape(scene.name)}[/]: remark: {escape(warning)}" for warning in scene.warnings]


def _line(scene: SceneResult, observation: ObservationResult, comparison: Comparison) -> str:
    colour = COLOURS[comparison.verdict.value]
    return f"[{colour}]{escape(scene.name)}.{escape(observation.name)}[/] {escape(sentence(observation, comparison))}"


def _table(results: Results) -> Table:
    table = Table(title="Comparison", title_justify="left")
    for column in ("scene", "verdict", "phenomena", "tracer CPU s", "POV-Ray CPU s"):
        table.add_column(column, justify="right" if "CPU" in column else "left")
    for scene in results.scenes:
        word = scene.verdict.value if scene.verdict else scene.status.value
        phenomena = ", ".join(
            f"[{COLOURS[entry.verdict.value]}]{entry.phenomenon.value}[/]" for entry in scene.observations
        )
        seconds = {engine.engine: engine.cpu_s for engine in scene.engines}
        cells = [f"{seconds[side]:.2f}" if seconds.get(side) is not None else "" for side in ("tracer", "povray")]
        table.add_row(escape(scene.name), f"[{COLOURS.get(word, 'red')}]{word}[/]", phenomena, *cells)
    return table
