"""The stages of a comparison can be called one after the other, and every value between them can be printed."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.pipeline.doubles import CARD, FormulaEngine
from vitrail.base.canonical_json import canonical_json
from vitrail.base.engine_name import EngineName
from vitrail.base.fault import Fault
from vitrail.base.phenomenon import Phenomenon
from vitrail.engines.base import Rendering
from vitrail.images.exr import read_image
from vitrail.pipeline.job import prepare
from vitrail.pipeline.run import finished, run
from vitrail.plan.analyse import everything
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded, load_text


@pytest.fixture
def card() -> Loaded:
    return load_text(CARD, "card.yaml")


def test_load_plan_lower_run_one_after_the_other(card: Loaded, tmp_path: Path) -> None:
    job = prepare(card, Quality.DRAFT, {"samples": 3})
    assert "required=True" in str(job.plan)
    assert "samples=3" in str(job.settings)
    lowered = job.lowered(EngineName.TRACER)
    assert '"samples": 3' in canonical_json(lowered)
    assert "light_source" in job.lowered(EngineName.POVRAY).runs[0].sdl
    rendering = run(job, FormulaEngine("tracer"), tmp_path)
    assert read_image(rendering.image_path).radiance.shape == (32, 32, 3)


def test_a_changed_scene_keeps_plan_and_settings(card: Loaded) -> None:
    job = prepare(card, Quality.DRAFT)
    other = job.with_scene(card.scene.model_copy(update={"title": "other"}))
    assert other.lowered(EngineName.TRACER)["title"] == "other"
    assert (other.plan, other.settings) == (job.plan, job.settings)


def test_a_planner_may_leave_nothing_out(card: Loaded) -> None:
    assert not prepare(card).plan.requires(Phenomenon.SHADOW)
    assert prepare(card, planner=everything).plan.requires(Phenomenon.SHADOW)


def test_a_setting_that_cannot_be_is_refused_before_anything_is_rendered(card: Loaded) -> None:
    with pytest.raises(Fault, match="samples"):
        prepare(card, Quality.DRAFT, {"samples": 0})


def test_an_image_that_was_cut_short_is_never_measured(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        finished(Rendering(tmp_path / "tracer.exr", {"interrupted": True}))
