"""The options that choose how much work a rendering may do, shared by the verbs that render or emit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from vitrail.base.fault import Fault
from vitrail.commands.errors import usage_error
from vitrail.plan.settings import Quality, setting_names

if TYPE_CHECKING:
    from vitrail.pipeline.job import Job
    from vitrail.scene.load import Loaded

QUALITY = typer.Option(Quality.NORMAL, "--quality", help="How much work, where no setting says it.")
SETTINGS = typer.Option(
    [],
    "--set",
    metavar="KEY=VALUE",
    help=f"Replace one setting; may be repeated. They are {', '.join(setting_names())}.",
)


def prepared(loaded: Loaded, quality: Quality, assignments: list[str], **options: object) -> Job:
    """A scene with its plan, and the settings that were asked for on the command line.

    ``options`` that are None were not given; ``--set`` wins over them.
    """
    from vitrail.pipeline.job import prepare

    given = {key: value for key, value in options.items() if value is not None}
    typed = {key: f"--{key} {value}" for key, value in given.items()}
    for assignment in assignments:
        key, sign, value = assignment.partition("=")
        if not sign:
            raise usage_error(f"--set {assignment}: has no value; write key=value")
        given[key.strip()] = value.strip()
        typed[key.strip()] = f"--set {assignment}"
    try:
        return prepare(loaded, quality, given)
    except Fault as fault:
        raise usage_error(f"{typed[str(fault.path[0])]}: {fault.what}; {fault.remedy}") from None
