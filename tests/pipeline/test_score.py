"""Images of any program: the same gates and verdicts, and a message of its own for each way an image can be wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from tests.pipeline.doubles import CARD
from tests.pipeline.test_compare import RULES, TRUTH
from vitrail.images.exr import ImageError, write_image
from vitrail.judge.comparison import Pair, Verdict
from vitrail.judge.records import Results, Status
from vitrail.pipeline.score import score
from vitrail.scene.load import Loaded, load
from vitrail.scene.print import scene_hash

GREY = np.full((32, 32, 3), 0.5)


@pytest.fixture
def card(tmp_path: Path) -> Loaded:
    (tmp_path / "references").mkdir()
    (tmp_path / "references" / "thresholds.yaml").write_text(RULES)
    (tmp_path / "references" / "analytic.yaml").write_text(TRUTH)
    (tmp_path / "card.yaml").write_text(CARD)
    return load(tmp_path / "card.yaml")


def scored(card: Loaded, radiance: np.ndarray, **metadata: str) -> Results:
    """The verdict on ``radiance`` against an even grey."""
    folder = card.path.parent
    write_image(folder / "candidate.exr", radiance, metadata=metadata)
    write_image(folder / "reference.exr", GREY)
    files = {"candidate": folder / "candidate.exr", "reference": folder / "reference.exr"}
    return score(card, files, folder / "out")


def test_a_foreign_image_is_held_against_the_reference_and_the_formula(card: Loaded) -> None:
    results = scored(card, GREY)
    comparisons = results.scenes[0].observations[0].comparisons
    assert {entry.pair for entry in comparisons} == {
        Pair.CANDIDATE_REFERENCE,
        Pair.CANDIDATE_TRUTH,
        Pair.REFERENCE_TRUTH,
    }
    assert results.exit_code == 0
    assert all("no half images" in " ".join(entry.caveats) for entry in comparisons)


def test_two_percent_of_tint_is_a_deviation_of_the_candidate(card: Loaded) -> None:
    results = scored(card, GREY * [1.0, 1.0, 0.98])
    observation = results.scenes[0].observations[0]
    red = {entry.metric for entry in observation.comparisons if entry.verdict is Verdict.DEVIATES}
    assert results.exit_code == 1 and red == {"radiance_ratio.blue"}


def nan(radiance: np.ndarray) -> np.ndarray:
    radiance[2, 1, 0] = np.nan
    return radiance


@pytest.mark.parametrize(
    ("spoil", "metadata", "says"),
    [
        (nan, {}, "nan at pixel x=1 y=2 (channel R), 1 bad in all"),
        (lambda radiance: radiance[:-1], {}, "is 32 x 31, the scene says 32 x 32"),
        (lambda radiance: radiance * 0, {}, "is black everywhere"),
        (lambda radiance: radiance, {"vitrail:exposure_stops": "2"}, "was exposed by 2 stops"),
        (lambda radiance: radiance, {"vitrail:scene_hash": "f" * 64}, "shows scene ffffffffffff"),
    ],
)
def test_each_bad_image_fails_with_its_own_message(
    card: Loaded, spoil: Callable[[np.ndarray], np.ndarray], metadata: dict[str, str], says: str
) -> None:
    results = scored(card, spoil(GREY.copy()), **metadata)
    scene = results.scenes[0]
    assert (scene.status, results.exit_code) == (Status.GATE_FAILED, 2)
    assert says in scene.message
    assert scene.observations == () and len([gate for gate in scene.gates if not gate.passed]) == 1


def test_an_image_of_this_scene_may_say_so(card: Loaded) -> None:
    assert scored(card, GREY, **{"vitrail:scene_hash": scene_hash(card.scene)}).exit_code == 0


def test_a_missing_image_is_said(card: Loaded) -> None:
    folder = card.path.parent
    files = {"candidate": folder / "none.exr", "reference": folder / "none.exr"}
    with pytest.raises(ImageError, match="no such image"):
        score(card, files, folder / "out")
