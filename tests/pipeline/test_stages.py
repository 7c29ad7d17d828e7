"""Load, prepare, lower, run, measure, judge, one after the other, with a value to look at in between."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.pipeline.doubles import CARD, FormulaEngine
from tests.pipeline.test_compare import RULES, TRUTH
from vitrail.base.canonical_json import canonical_json
from vitrail.judge.comparison import Verdict
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.compare import compare
from vitrail.pipeline.gated_images import open_images
from vitrail.pipeline.gated_views import open_views
from vitrail.pipeline.job import prepare
from vitrail.pipeline.judge import judge
from vitrail.pipeline.lowered import lower
from vitrail.pipeline.measurements import Measurements
from vitrail.pipeline.request import Request
from vitrail.pipeline.run_both import run_both
from vitrail.pipeline.scene_record import record_of_job
from vitrail.pipeline.scene_run import SceneRun
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded, load


@pytest.fixture
def card(tmp_path: Path) -> Loaded:
    (tmp_path / "references").mkdir()
    (tmp_path / "references" / "thresholds.yaml").write_text(RULES)
    (tmp_path / "references" / "analytic.yaml").write_text(TRUTH)
    (tmp_path / "card.yaml").write_text(CARD)
    return load(tmp_path / "card.yaml")


def test_the_stages_can_be_called_one_by_one_and_give_what_compare_gives(tmp_path: Path, card: Loaded) -> None:
    engines = {"tracer": FormulaEngine("tracer", radiance=0.55), "povray": FormulaEngine("povray")}
    request = Request(out=tmp_path / "out", quality=Quality.DRAFT, engines=engines)
    references, place = tmp_path / "references", tmp_path / "out" / "card"

    job = prepare(card, request.quality, request.overrides).with_views()
    assert "samples=1" in str(job) and "diffusion" in str(job.plan)

    lowered = lower(job, request)
    assert '"title": "Grey card"' in canonical_json(lowered.tracer)
    assert lowered.povray is not None and "light_source" in lowered.povray.runs[0].sdl

    rendered = run_both(lowered, place, request)
    assert {side: made.record["engine"] for side, made in rendered.items()} == {"tracer": "tracer", "povray": "povray"}

    record, images = open_images(record_of_job(job, "card", request), rendered, None, place, job.times)
    record, views = open_views(record, job.scene, job.views, rendered, place)
    assert all(gate.passed for gate in record.gates)
    assert images["tracer"].radiance.mean() == pytest.approx(0.55)

    measured = Measurements(job.scene, "card", references, job.settings, images, None, views, job.times)
    (observed,) = measured.observations()
    reds = sorted(entry.value for entry in observed.measured if entry.metric == "mean_radiance.red")
    assert reds == pytest.approx([0.5, 0.55])

    record = record.model_copy(update={"global_metrics": measured.whole_images()})
    results = judge([SceneRun(record, (observed,), lowered.certificate.bound, references)], about_run(()))
    assert results.verdict is Verdict.DEVIATES

    whole = compare([card], request)
    assert [each.verdict for each in whole.scenes[0].observations] == [Verdict.DEVIATES]
    assert whole.false_alarms == results.false_alarms
