"""Results for machines: GitHub annotations with a job summary, and JUnit XML."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, assert_never
from xml.etree import ElementTree

import typer

from vitrail.commands.comparison_sentence import sentence, where
from vitrail.commands.output import print_json
from vitrail.judge.comparison import ObservationResult, Verdict
from vitrail.judge.records import Results, SceneResult

if TYPE_CHECKING:
    from vitrail.scene.load import Loaded

VERBOSE = typer.Option(False, "--verbose", "-v", help="Tell also what is open, what would decide it, and remarks.")

Line = Callable[[SceneResult, str | None], int]
"""The line of the scene's file that a result is about: that of an observation, or of the scene."""


class Format(StrEnum):
    """How results are printed."""

    HUMAN = "human"
    JSON = "json"
    GITHUB = "github"
    JUNIT = "junit"


def print_in(form: Format, results: Results, page: Path, loaded: Sequence[Loaded], *, verbose: bool = False) -> None:
    """Print the results of ``loaded`` scenes in one form; ``verbose`` tells people also what is open."""
    match form:
        case Format.HUMAN:
            from vitrail.commands.verdict_table import print_results

            print_results(results, page, verbose=verbose)
        case Format.JSON:
            print_json(results.model_dump(mode="json"))
        case Format.GITHUB:
            for line in github_annotations(results, lines_of(loaded)):
                typer.echo(line)
            summary = os.environ.get("GITHUB_STEP_SUMMARY")
            if summary:
                with Path(summary).open("a", encoding="utf-8") as file:
                    file.write(job_summary(results))
        case Format.JUNIT:
            typer.echo(junit(results))
        case _:
            assert_never(form)


def lines_of(loaded: Sequence[Loaded]) -> Line:
    """Where observations are written."""
    places: Mapping[str, Loaded] = {str(each.path): each for each in loaded}

    def line(scene: SceneResult, observation: str | None) -> int:
        known = places.get(scene.source)
        if known is None or observation is None:
            return 1
        names = [each.name for each in known.scene.observe]
        return known.places.of("observe", names.index(observation))[0] if observation in names else 1

    return line


def github_annotations(results: Results, line: Line) -> list[str]:
    """Workflow commands: an error for what deviates or failed, a warning for what is in doubt or remarked on."""
    found = []
    for scene in results.scenes:
        if scene.message:
            found.append(_annotation("error", scene, line(scene, None), scene.status.value, scene.message))
        for warning in scene.warnings:
            found.append(_annotation("warning", scene, line(scene, None), "remark", warning))
        for observation in scene.observations:
            level = {Verdict.DEVIATES: "error", Verdict.INCONCLUSIVE: "warning"}.get(observation.verdict)
            if level is None:
                continue
            told = [
                sentence(observation, each) for each in observation.comparisons if each.verdict is observation.verdict
            ]
            said = [observation.statement, *told, *where(observation), *observation.unmeasured]
            text = "\n".join([*said, f"again: {scene.reproduce}"])
            title = f"{scene.name}.{observation.name} {_how_close(observation)}"
            found.append(_annotation(level, scene, line(scene, observation.name), title, text))
    return found


def job_summary(results: Results) -> str:
    """A table in Markdown: a row a scene."""
    rows = ["## Vitrail", "", results.statement, ""]
    rows += ["| scene | how close | verdict | phenomena | why |", "|---|---|---|---|---|"]
    for scene in results.scenes:
        word = scene.verdict.value if scene.verdict else scene.status.value
        phenomena = ", ".join(f"{each.phenomenon.value} {each.verdict.value}" for each in scene.observations)
        why = scene.message or next(
            (
                sentence(observation, each)
                for observation in scene.observations
                for each in observation.comparisons
                if each.verdict is scene.verdict is not Verdict.AGREES
            ),
            "",
        )
        cells = (scene.name, scene.statement, word, phenomena, why)
        rows.append("| " + " | ".join(cell.replace("|", "\\|").replace("\n", "<br>") for cell in cells) + " |")
    shared = results.false_alarms
    rows += [
        "",
        f"{shared.comparisons} comparisons at a false-alarm rate of {100 * shared.suite_rate:g} % for the run.",
        "",
    ]
    return "\n".join(rows)


def junit(results: Results) -> str:
    """A suite a scene, a case an observation: failures deviate, errors could not be judged, doubt is a failure too."""
    root = ElementTree.Element("testsuites", name="vitrail")
    for scene in results.scenes:
        suite = ElementTree.SubElement(root, "testsuite", name=scene.name, file=scene.source)
        cases = [_case(suite, scene, each) for each in scene.observations]
        if scene.message:
            case = ElementTree.SubElement(suite, "testcase", classname=scene.name, name=scene.status.value)
            ElementTree.SubElement(case, "error", message=scene.message.splitlines()[0]).text = scene.message
            cases.append("error")
        suite.set("tests", str(len(cases)))
        suite.set("failures", str(cases.count("failure")))
        suite.set("errors", str(cases.count("error")))
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True)


def _case(suite: ElementTree.Element, scene: SceneResult, observation: ObservationResult) -> str:
    case = ElementTree.SubElement(suite, "testcase", classname=scene.name, name=observation.name)
    known = ElementTree.SubElement(case, "properties")
    ElementTree.SubElement(known, "property", name="statement", value=observation.statement)
    for entry in observation.comparisons:
        name = f"{entry.pair.value} {entry.metric}"
        ElementTree.SubElement(known, "property", name=name, value=entry.statement)
    if observation.verdict is Verdict.AGREES:
        return "success"
    told = [sentence(observation, each) for each in observation.comparisons if each.verdict is observation.verdict]
    failure = ElementTree.SubElement(case, "failure", type=observation.verdict.value, message=observation.statement)
    failure.text = "\n".join(
        [observation.statement, *told, *where(observation), *observation.unmeasured, f"again: {scene.reproduce}"]
    )
    return "failure"


def _how_close(observation: ObservationResult) -> str:
    """The end of a title: what is open is known to a bound, the one that is most tolerances wide."""
    if observation.verdict is Verdict.INCONCLUSIVE and observation.bound is not None:
        return f"known to {observation.bound.words} (inconclusive)"
    return observation.verdict.value


def _annotation(level: str, scene: SceneResult, line: int, title: str, text: str) -> str:
    """One workflow command; its grammar wants these characters escaped."""
    escaped = text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
    place = scene.source.replace("%", "%25").replace(",", "%2C").replace(":", "%3A")
    name = title.replace("%", "%25").replace(",", "%2C").replace(":", "%3A")
    return f"::{level} file={place},line={line},title={name}::{escaped}"
