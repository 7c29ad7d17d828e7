"""A mistake whose effect lies outside every patch leaves all numbers alike; the scan of the whole picture finds it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.end_to_end.conftest import Compare
from vitrail.base.changed import changed
from vitrail.judge.comparison import Verdict
from vitrail.pipeline.defect import Defect
from vitrail.scene.model import Scene

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

SCENE = Path(__file__).parent / "beside_the_patch.yaml"


def darker(share: float) -> Defect:
    """POV-Ray's side reads the other card as darker by a share."""

    def misread(scene: Scene) -> Scene:
        other = scene.materials["other"]
        dark = changed(other, diffuse=tuple((1 - share) * value for value in other.diffuse))
        return changed(scene, materials={**scene.materials, "other": dark})

    return Defect(f"darker_by_{share}", misread_by_povray=misread)


def test_a_mutant_beside_every_patch_is_caught_by_the_scan(compared: Compare) -> None:
    results = compared(SCENE, defect=darker(0.2))
    (scene,) = results.scenes
    assert scene.observations[0].verdict is Verdict.AGREES
    assert scene.scan is not None
    (place,) = scene.scan.places
    assert (place.object, place.layer, place.observations) == ("card", "diffusion", ())
    assert place.tracer / place.povray == pytest.approx(1 / 0.8, rel=0.01)
    assert place.deviates and scene.verdict is Verdict.DEVIATES and results.exit_code == 1


def test_a_small_mistake_beside_every_patch_is_a_warning(compared: Compare) -> None:
    results = compared(SCENE, defect=darker(0.04))
    (scene,) = results.scenes
    assert scene.scan is not None and [place.object for place in scene.scan.places] == ["card"]
    assert "4.2 % brighter in the tracer" in scene.scan.places[0].words
    assert scene.verdict is Verdict.AGREES and results.exit_code == 0


def test_without_the_mistake_nothing_is_found(compared: Compare) -> None:
    (scene,) = compared(SCENE).scenes
    assert scene.scan is not None and scene.scan.places == ()
