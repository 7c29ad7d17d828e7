"""The plan's table: each phenomenon taken out changes what it should, and slowness is told from scatter."""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import read_record
from vitrail.geometry.world import World
from vitrail.pipeline.task import Row
from vitrail.pipeline.task_log import read_rows
from vitrail.plan.analyse import analyse
from vitrail.report.plans_page import write_plans_page
from vitrail.scene.load import load
from vitrail.study.tradeoff.plan_records import Plans
from vitrail.study.tradeoff.plan_study import analyse_plans, run_plan_study
from vitrail.study.tradeoff.removal import HOW, without

pytestmark = pytest.mark.tracer

SCENES = Path(__file__).resolve().parents[3] / "scenes"


def _row(name: str, planned: list[float], whole: list[float]) -> Row:
    same = {"relative_l1": 0.0, "same_bits": True, "sigmas": None, "outside_noise": 0.0}
    result = {"required": [], "differences": {"everything": same}}
    return Row(name, "variants", {"name": name}, result, None, {"cpu_s": {"plan": planned, "everything": whole}})


@pytest.mark.parametrize(
    ("planned", "whole", "is_slower"),
    [
        ([1.00, 1.02, 1.01], [1.00, 1.01, 1.02], False),  # the same but for scatter
        ([1.50, 1.52, 1.51], [1.00, 1.01, 1.02], True),  # half as long again
        ([0.90, 2.50, 0.91], [1.00, 1.01, 1.02], False),  # disturbed once, else faster
    ],
)
def test_slower_is_what_scatter_cannot_explain(planned: list[float], whole: list[float], is_slower: bool) -> None:
    found = analyse_plans([_row("a", planned, whole)])
    assert found.scenes[0].slower is is_slower
    assert found.summary.slower == (("a",) if is_slower else ())
    assert found.summary.cpu_s == {"plan": min(planned), "everything": min(whole)}


def test_the_measured_table_of_two_scenes(tmp_path: Path) -> None:
    loaded = [load(SCENES / "calibration" / f"{name}.yaml") for name in ("tinted_pane_projected", "mirror")]
    found = run_plan_study(loaded, tmp_path, jobs=2)
    pane, mirror = found.scenes
    assert all(scene.differences["everything"].same_bits for scene in (pane, mirror))
    # Grey glass in place of t^2 = 0.81, 0.25, 0.04: with t = 1.6 / 3 the channels change by 0.526, 0.034, 0.244 of 1.1.
    assert pane.differences["coloured_transmission"].relative_l1 == pytest.approx(0.7313, abs=2e-3)
    # All the light on the floor under the pane has come through it; all that a mirror shows is mirrored.
    assert pane.differences["caustic"].relative_l1 == pytest.approx(1.0)
    assert mirror.differences["reflection"].relative_l1 == pytest.approx(1.0)
    assert analyse_plans(read_rows(tmp_path)) == read_record(Plans, tmp_path / "plans.json") == found
    assert "same bits" in write_plans_page(tmp_path, found).read_text()


def test_every_phenomenon_can_be_taken_out_of_a_scene_that_has_it() -> None:
    scene = load(SCENES / "paper" / "goblet.yaml").scene
    plan = analyse(World.of_scene(scene))
    assert set(HOW) == set(Phenomenon)
    for phenomenon in Phenomenon:
        less, less_plan = without(scene, plan, phenomenon)
        assert not less_plan.requires(phenomenon)
        if plan.requires(phenomenon):
            flag_alone = less == scene and less_plan.chain == plan.chain
            by_plan = {"absorption", "caustic", "shadow", "indirect_light"}
            assert flag_alone == (phenomenon.value in by_plan), phenomenon
