"""The options that choose how much work a rendering may do, shared by the verbs that render or emit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from vitrail.base.fault import Fault
from vitrail.commands.exit_code import usage_error
from vitrail.plan.settings import Quality, setting_names

if TYPE_CHECKING:
    from vitrail.geometry.world import World
    from vitrail.plan.plan import Plan
    from vitrail.plan.settings import Settings

QUALITY = typer.Option(Quality.NORMAL, "--quality", help="How much work, where no setting says it.")
SETTINGS = typer.Option(
    [],
    "--set",
    metavar="KEY=VALUE",
    help=f"Replace one setting; may be repeated. They are {', '.join(setting_names())}.",
)


def parse_settings(world: World, plan: Plan, quality: Quality, assignments: list[str], **options: object) -> Settings:
    """Settings from the command line. ``options`` that are None were not given; ``--set`` wins over them."""
    from vitrail.plan.budget import settings_for

    given = {key: value for key, value in options.items() if value is not None}
    typed = {key: f"--{key} {value}" for key, value in given.items()}
    for assignment in assignments:
        key, sign, value = assignment.partition("=")
        if not sign:
            raise usage_error(f"--set {assignment}: has no value; write key=value")
        given[key.strip()] = value.strip()
        typed[key.strip()] = f"--set {assignment}"
    try:
        return settings_for(world, plan, quality, **given)
    except Fault as fault:
        raise usage_error(f"{typed[str(fault.path[0])]}: {fault.what}; {fault.remedy}") from None
