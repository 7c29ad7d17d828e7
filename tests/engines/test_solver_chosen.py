"""`auto` in the tracer is what the plan says, lamp by lamp in the run record."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.plan.small_scenes import SUN, ball_over_floor
from tests.plan.test_solver_choice import PANEL, WIDE_SUN
from vitrail.engines.tracer import Tracer
from vitrail.geometry.world import World
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.plan.solver_choice import solver_choice

pytestmark = pytest.mark.tracer


@pytest.mark.parametrize(
    ("material", "lights", "photons"),
    [
        ("clear", (SUN,), 10_000),
        ("clear", (PANEL, SUN), 10_000),
        ("clear", (WIDE_SUN,), 40_000),
        ("clear", (WIDE_SUN,), 39_000),
        ("frosted", (SUN,), 200_000),
    ],
)
def test_the_tracer_takes_what_the_plan_says(
    material: str, lights: tuple[str, ...], photons: int, tmp_path: Path
) -> None:
    world = World.of_scene(ball_over_floor(material, lights=lights))
    plan = analyse(world)
    settings = settings_for(world, plan, "draft", photons=photons, solver="auto")  # type: ignore[arg-type]
    record: dict[str, Any] = Tracer().render(lower_tracer(world, plan, settings), tmp_path).record
    choice = solver_choice(world.scene, plan, settings)
    assert choice is not None
    assert record["settings"]["solver"] == choice.solver

    # Only the light of the sun without a diameter goes as beams.
    routes = {each["light"]: each["as"] for each in record["light_routes"]}
    alone = choice.solver == "beams"
    assert routes == {"sun": "beams" if alone else "photons"} | ({"panel": "photons"} if PANEL in lights else {})
