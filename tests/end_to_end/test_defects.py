"""A known mistake in the translation turns its phenomenon red and names POV-Ray where a formula is known."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.end_to_end.conftest import ROOT, Compare
from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import AblationOutcome, Verdict
from vitrail.judge.records import Results
from vitrail.pipeline.defects import DEFECTS

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

CALIBRATION = ROOT / "scenes" / "calibration"


def red(results: Results) -> set[Phenomenon]:
    """The phenomena that deviate."""
    return {
        entry.phenomenon
        for scene in results.scenes
        for entry in scene.observations
        if entry.verdict is Verdict.DEVIATES
    }


@pytest.mark.parametrize(
    ("defect", "scene", "phenomenon", "stays_without"),
    [
        ("missing_pi", "grey_card_directional", Phenomenon.DIFFUSION, set()),
        ("naive_fade", "beer_slab", Phenomenon.ABSORPTION, {"refraction"}),
        ("photon_overflow", "ball_lens", Phenomenon.CAUSTIC, {"refraction"}),
    ],
)
def test_the_right_phenomenon_turns_red(
    compared: Compare, defect: str, scene: str, phenomenon: Phenomenon, stays_without: set[str]
) -> None:
    path = CALIBRATION / f"{scene}.yaml"
    results = compared(path, defect=DEFECTS[defect])
    assert red(results) == {phenomenon}
    assert results.exit_code == 1
    observation = next(o for o in results.scenes[0].observations if o.verdict is Verdict.DEVIATES)
    if any(entry.pair.reference == "truth" for entry in observation.comparisons):
        assert observation.attribution is not None and observation.attribution.engine == "povray"
    # The scene with one thing after the other switched off says the same, without knowing any formula.
    assert observation.where is not None and observation.where.suspects == (phenomenon,), observation.where
    assert {
        entry.off for entry in observation.where.ablations if entry.outcome is AblationOutcome.STAYS
    } == stays_without


@pytest.mark.parametrize("scene", ["grey_card_directional", "beer_slab"])
def test_without_the_defect_the_scene_is_not_red(compared: Compare, scene: str) -> None:
    assert red(compared(CALIBRATION / f"{scene}.yaml")) == set()


def test_a_lost_caustic_is_red_while_the_whole_image_still_looks_alike(compared: Compare) -> None:
    """Structural similarity above 0.95 for a picture whose caustic is gone: why there are metrics for phenomena."""
    path = Path(__file__).parent / "lost_caustic.yaml"
    results = compared(path, defect=DEFECTS["photon_overflow"], budget_s=0)
    (scene,) = results.scenes
    ssim = next(metric.value for metric in scene.global_metrics if metric.metric == "ssim")
    assert ssim > 0.95
    assert red(results) == {Phenomenon.CAUSTIC}
    assert results.exit_code == 1
    flux = next(e for e in scene.observations[0].comparisons if e.metric == "flux_ratio.red")
    # The tracer has all of the caustic and POV-Ray next to nothing.
    assert flux.value > 10
    # Nothing was left to pay for ablations: what is not known is said, with its price.
    where = scene.observations[0].where
    assert where is not None and Phenomenon.CAUSTIC in where.suspects
    assert "not tried" in where.reason and "--budget-s" in where.reason
