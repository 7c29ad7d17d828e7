"""The options that choose how much work a rendering may do, shared by the verbs that render or emit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from vitrail.commands.exit_code import usage_error

if TYPE_CHECKING:
    from vitrail.geometry.world import World
    from vitrail.plan.budget import Settings
    from vitrail.plan.plan import Plan

QUALITY = typer.Option("normal", "--quality", help="draft, normal or reference.")
SETTINGS = typer.Option([], "--set", metavar="KEY=VALUE", help="Replace one setting; may be repeated.")


def parse_settings(world: World, plan: Plan, quality: str, assignments: list[str], **options: object) -> Settings:
    """Settings from the command line. ``options`` that are None were not given; ``--set`` wins over them."""
    from vitrail.plan.budget import QUALITIES, settings_for

    if quality not in QUALITIES:
        raise usage_error(f"--quality {quality}: choose one of {', '.join(QUALITIES)}")
    overrides = {key: value for key, value in options.items() if value is not None}
    for assignment in assignments:
        key, sign, value = assignment.partition("=")
        if not sign:
            raise usage_error(f"--set {assignment}: write key=value")
        overrides[key.strip()] = value.strip()
    try:
        return settings_for(world, plan, quality, **overrides)
    except ValueError as error:
        raise usage_error(f"settings: {error}") from None
