"""Accepted images: stored with a reason, found changed or missing, and held against what is rendered now."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.pipeline.doubles import CARD, FormulaEngine
from tests.pipeline.test_compare import RULES
from vitrail.images.exr import read_image, write_image
from vitrail.judge.comparison import Pair, Verdict
from vitrail.judge.records import Results
from vitrail.judge.reference_files import ReferencesError
from vitrail.judge.stored import read_stored
from vitrail.pipeline.accept import propose_from_run, propose_rendering
from vitrail.pipeline.compare import compare
from vitrail.pipeline.request import Request
from vitrail.scene.load import Loaded, load
from vitrail.scene.print import scene_hash

STORED_RULES = RULES.replace("metrics:", "stored_image: {ssim: {absolute: 0.005, reason: for this test}}\nmetrics:")


@pytest.fixture
def card(tmp_path: Path) -> Loaded:
    (tmp_path / "references").mkdir()
    (tmp_path / "references" / "thresholds.yaml").write_text(STORED_RULES)
    (tmp_path / "card.yaml").write_text(CARD)
    return load(tmp_path / "card.yaml")


def references(card: Loaded) -> Path:
    return card.path.parent / "references"


def bless(card: Loaded, engine: FormulaEngine | None = None, because: str = "the closed form says so") -> Path:
    proposal = propose_rendering(
        card,
        references(card),
        because,
        card.path.parent / "work",
        engine=engine or FormulaEngine("tracer", noise=0.2),
        quality="draft",
        overrides={"samples": 4},
    )
    return proposal.accept()


def against_stored(card: Loaded, tracer: FormulaEngine, *against: str) -> Results:
    engines = {"tracer": tracer, "povray": FormulaEngine("povray")}
    out = card.path.parent / "out"
    return compare([card], Request(out=out, engines=engines, against=against or ("stored",)))


def test_an_unchanged_program_agrees_with_its_stored_image_however_noisy(card: Loaded) -> None:
    bless(card)
    results = against_stored(card, FormulaEngine("tracer", noise=0.2))
    (scene,) = results.scenes
    assert results.exit_code == 0, [e.reason for o in scene.observations for e in o.comparisons]
    assert {entry.pair for entry in scene.observations[0].comparisons} == {Pair.TRACER_STORED}
    assert scene.settings["samples"] == 4, "the recipe of the stored image is used"
    assert [image.side for image in scene.images] == ["tracer", "stored"]


def test_one_percent_of_light_is_a_regression(card: Loaded) -> None:
    bless(card)
    results = against_stored(card, FormulaEngine("tracer", noise=0.2, radiance=0.5 * 1.02))
    assert results.exit_code == 1
    attribution = results.scenes[0].observations[0].attribution
    assert attribution is not None and attribution.engine == "tracer" and "accepted" in attribution.reason


def test_a_pattern_that_no_observation_sees_is_found_by_the_whole_image(card: Loaded) -> None:
    def stripe(image: np.ndarray) -> np.ndarray:
        image[2:5] *= 1.5
        return image

    bless(card, FormulaEngine("tracer"))
    results = against_stored(card, FormulaEngine("tracer", spoil=stripe))
    (scene,) = results.scenes
    assert scene.observations[0].verdict is Verdict.AGREES
    judged = {metric.metric: metric.verdict for metric in scene.global_metrics if metric.verdict is not None}
    assert judged == {"ssim": Verdict.DEVIATES} and results.exit_code == 1


def test_povray_and_the_stored_image_can_be_held_against_together(card: Loaded) -> None:
    bless(card)
    results = against_stored(card, FormulaEngine("tracer", noise=0.2), "povray", "stored")
    pairs = {entry.pair for entry in results.scenes[0].observations[0].comparisons}
    assert pairs == {Pair.TRACER_POVRAY, Pair.TRACER_STORED}


def test_without_povray_nothing_is_asked_of_it(card: Loaded) -> None:
    bless(card)
    povray = FormulaEngine("povray", script=["it must not be called"])
    engines = {"tracer": FormulaEngine("tracer", noise=0.2), "povray": povray}
    results = compare([card], Request(out=card.path.parent / "out", engines=engines, against=("stored",)))
    assert results.exit_code == 0 and povray.renders == 0


def test_a_missing_reference_fails(card: Loaded) -> None:
    with pytest.raises(ReferencesError, match="there is no stored reference; accept one with `vitrail bless"):
        against_stored(card, FormulaEngine("tracer"))


def test_a_reference_of_a_changed_scene_fails(card: Loaded) -> None:
    bless(card)
    card.path.write_text(CARD.replace("exposure_stops: 0", "").replace("diffuse: 0.5", "diffuse: 0.6"))
    with pytest.raises(ReferencesError, match="look at the change and bless again"):
        against_stored(load(card.path), FormulaEngine("tracer"))


def test_a_reference_of_another_exposure_fails(card: Loaded) -> None:
    bless(card)
    card.path.write_text(CARD.replace("height: 32}", "height: 32, exposure_stops: 1}"))
    with pytest.raises(ReferencesError, match="shows scene"):
        against_stored(load(card.path), FormulaEngine("tracer"))


def test_a_tampered_image_is_noticed(card: Loaded) -> None:
    path = bless(card)
    image = read_image(path)
    write_image(path, image.radiance * 1.001, half_a=image.half_a, half_b=image.half_b)
    with pytest.raises(ReferencesError, match="not those that were accepted"):
        read_stored(references(card), "card", scene_hash(card.scene))


def test_a_reference_of_another_version_is_reported(card: Loaded) -> None:
    path = bless(card)
    provenance = path.with_name("provenance.yaml")
    provenance.write_text(provenance.read_text().replace('version: "1"', 'version: "0.9"'))
    results = against_stored(card, FormulaEngine("tracer", noise=0.2))
    assert results.scenes[0].warnings == ("the stored reference was made by tracer 0.9, this is 1",)


def test_a_reference_needs_a_reason_and_a_good_image(card: Loaded) -> None:
    with pytest.raises(ReferencesError, match="needs its reason"):
        bless(card, because="  ")
    with pytest.raises(ReferencesError, match="is black everywhere"):
        bless(card, FormulaEngine("tracer", radiance=0.0))
    assert not (references(card) / "card").exists()


def test_the_change_is_shown_before_it_is_accepted(card: Loaded) -> None:
    bless(card, FormulaEngine("tracer"))
    proposal = propose_rendering(
        card,
        references(card),
        "the lamp was too dim",
        card.path.parent / "work",
        engine=FormulaEngine("tracer", radiance=0.55),
        quality="draft",
        overrides={},
    )
    (observed,) = proposal.changes()
    moved = {entry.metric: entry.value for entry in observed.measured}
    assert moved["radiance_ratio.red"] == pytest.approx(1.1, rel=1e-3)
    assert proposal.older is not None and proposal.older.provenance.because == "the closed form says so"


@pytest.mark.parametrize("width", [1, 480])
def test_an_image_of_a_finished_run_is_accepted_with_its_recipe(card: Loaded, width: int) -> None:
    engines = {"tracer": FormulaEngine("tracer", noise=0.1), "povray": FormulaEngine("povray")}
    out = card.path.parent / "run"
    compare([card], Request(out=out, engines=engines, quality="draft", overrides={"seed": 7}, picture_width=width))
    (scene,) = json.loads((out / "results.json").read_text())["scenes"]
    again = FormulaEngine("tracer", noise=0.1)
    work = {"engine": again, "work": out / "work"}
    # The picture of that run is for people, larger or with fewer samples: what it shows is rendered as a reference is.
    propose_from_run(card, references(card), "looked at in the report", out, scene, **work).accept()
    assert again.renders == 1
    stored = read_stored(references(card), "card", scene_hash(card.scene))
    assert stored.provenance.settings["seed"] == 7 and stored.provenance.because == "looked at in the report"
    scene["scene_hash"] = "0" * 64
    with pytest.raises(ReferencesError, match="has changed since the run"):
        propose_from_run(card, references(card), "again", out, scene, **work)


def test_a_stored_image_is_small(card: Loaded) -> None:
    size = bless(card, FormulaEngine("tracer", noise=0.2)).stat().st_size
    assert size < 32 * 32 * 9 * 2 * 1.1, "three half-float images of pure noise, and little else"
