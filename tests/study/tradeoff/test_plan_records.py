"""What the plan saves and what a phenomenon costs, told only where the runs do not scatter as much."""

from __future__ import annotations

import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.study.tradeoff.plan_records import PlannedScene


def scene(scatter_s: float, required: tuple[Phenomenon, ...] = (Phenomenon.CAUSTIC,)) -> PlannedScene:
    """Everything takes 3 s, the plan 2, the plan without its caustic 1.5; the runs of the plan scatter."""
    return PlannedScene(
        name="ball",
        failure=None,
        cpu_s={"everything": 3.0, "plan": 2.0, "caustic": 1.5},
        runs_cpu_s={"everything": (3.0, 3.0), "plan": (2.0, 2.0 + scatter_s)},
        slower=False,
        required=required,
    )


@pytest.mark.parametrize(("scatter_s", "saved", "costs"), [(0.1, 1.0, 0.5), (0.6, 1.0, None), (1.1, None, None)])
def test_less_than_the_runs_scatter_is_no_saving(scatter_s: float, saved: float | None, costs: float | None) -> None:
    found = scene(scatter_s)
    assert found.saved_s == saved
    assert found.costs_s(Phenomenon.CAUSTIC) == costs


def test_a_scene_that_requires_nothing_saves_nothing() -> None:
    assert scene(0.1, ()).saved_s is None
