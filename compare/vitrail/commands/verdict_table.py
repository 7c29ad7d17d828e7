"""What a person reads in the terminal after a comparison: one line a scene, one block for what is wrong, what to open.

A line begins with how close the scene is known to agree and ends with its verdict. Everything else waits for ``-v``:
the numbers that are open, what would decide them, and remarks.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.markup import escape

from vitrail.commands.comparison_sentence import sentence, where

if TYPE_CHECKING:
    from vitrail.judge.comparison import Comparison, ObservationResult
    from vitrail.judge.records import Results, SceneResult
    from vitrail.judge.scan_records import DifferentPlace

COLOURS = {"agrees": "green", "deviates": "red", "inconclusive": "yellow"}
MOST_NUMBERS = 3
"""Numbers of one observation that the terminal tells, the widest first; the report has all."""


def print_results(results: Results, page: Path | None, *, verbose: bool = False) -> None:
    """A line a scene, what deviates or failed, with ``verbose`` what is open, the count, and the page to open."""
    console = Console(soft_wrap=True, highlight=False)
    width = max((len(scene.name) for scene in results.scenes), default=0)
    for scene in results.scenes:
        console.print(line(scene, width, verbose=verbose))
    wrong = [text for scene in results.scenes for text in trouble(scene)]
    for text in ["", *wrong] if wrong else []:
        console.print(text)
    more = [text for scene in results.scenes for text in remaining(scene)]
    for text in ["", *more] if more and verbose else []:
        console.print(text)
    console.print(f"\n{results.statement}{_hint(results) if more and not verbose else ''}")
    if page is not None:
        console.print(f"Open {page}")


def line(scene: SceneResult, width: int, *, verbose: bool = False) -> str:
    """Name, how close in its widest part, verdict; of a scene that was not judged the first line of why."""
    word = scene.verdict.value if scene.verdict else scene.status.value
    said = (
        (scene.statement if verbose else scene.headline) or scene.statement or (scene.message.splitlines() or [""])[0]
    )
    return f"{escape(scene.name.ljust(width))}  {escape(said)} [{COLOURS.get(word, 'red')}]{word}[/]"


def trouble(scene: SceneResult) -> list[str]:
    """What failed and why, what deviates and by how much, and the line to make it again."""
    lines = [f"[red]{escape(scene.name)}[/]: {escape(scene.message)}"] if scene.message else []
    for observation in scene.observations:
        if observation.verdict.value == "deviates":
            lines += _numbers(scene, observation)
            lines += [f"  {escape(text)}" for text in where(observation)]
    lines += [_place(scene, each) for each in places(scene) if each.deviates]
    if lines and scene.reproduce:
        lines.append(f"  again: {escape(scene.reproduce)}")
    return lines


def remaining(scene: SceneResult) -> list[str]:
    """What is open and what would decide it, and what must be remarked on."""
    lines = []
    for observation in scene.observations:
        if observation.verdict.value == "inconclusive":
            lines += _numbers(scene, observation)
        lines += [f"  not measured: {escape(reason)}" for reason in observation.unmeasured]
    lines += [_place(scene, each) for each in places(scene) if not each.deviates]
    if scene.more_samples is not None:
        lines.append(f"  [yellow]{escape(scene.name)}[/]: open: {escape(scene.more_samples.reason)}")
    return lines + [f"[yellow]{escape(scene.name)}[/]: remark: {escape(warning)}" for warning in scene.warnings]


def places(scene: SceneResult) -> tuple[DifferentPlace, ...]:
    """Where the scan of the whole picture found a difference that no patch holds."""
    return () if scene.scan is None else tuple(each for each in scene.scan.places if not each.observations)


def _place(scene: SceneResult, place: DifferentPlace) -> str:
    return f"[{'red' if place.deviates else 'yellow'}]{escape(scene.name)}[/] {escape(place.words)}"


def _numbers(scene: SceneResult, observation: ObservationResult) -> list[str]:
    """The widest numbers of an observation's verdict, and how many more there are."""
    own = [entry for entry in observation.comparisons if entry.verdict is observation.verdict]
    told = sorted(own, key=_width, reverse=True)[:MOST_NUMBERS]
    lines = [_line(scene, observation, entry) for entry in told]
    rest = len(own) - len(told)
    return [*lines, *([f"  and {rest} more number{'s' if rest > 1 else ''} of it, in the report"] if rest else [])]


def _width(entry: Comparison) -> float:
    return entry.bound.over_tolerance or 0.0 if entry.bound is not None else 0.0


def _line(scene: SceneResult, observation: ObservationResult, comparison: Comparison) -> str:
    colour = COLOURS[comparison.verdict.value]
    return f"[{colour}]{escape(scene.name)}.{escape(observation.name)}[/] {escape(sentence(observation, comparison))}"


def _hint(results: Results) -> str:
    """What ``-v`` would tell."""
    opened = sum(scene.verdict is not None and scene.verdict.value == "inconclusive" for scene in results.scenes)
    remarks = sum(len(scene.warnings) for scene in results.scenes)
    parts = ["what would decide the rest"] if opened else []
    parts += [f"{remarks} remark{'s' if remarks > 1 else ''}"] if remarks else []
    return f" -v tells {' and '.join(parts)}." if parts else ""
