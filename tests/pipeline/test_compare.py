"""From scenes to verdicts with engines made of formulas: verdicts, failures, interruption, what is kept."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from tests.pipeline.doubles import CARD, FormulaEngine
from vitrail.engines.base import EngineFailure
from vitrail.judge.comparison import Pair, Verdict
from vitrail.judge.records import Results, SceneResult, Status, read_results
from vitrail.judge.reference_files import ReferencesError
from vitrail.pipeline.compare import compare
from vitrail.pipeline.defect import Defect
from vitrail.pipeline.request import Request
from vitrail.pipeline.run_both import check_photons
from vitrail.pipeline.suite import scene_names
from vitrail.scene.load import Loaded, load

RULES = """
version: 1
suite_false_alarm_rate: {value: 0.01, reason: for this test}
metrics:
  mean_radiance: {relative: 0.01, reason: for this test}
  radiance_ratio: {relative: 0.01, reason: for this test}
  tilt: {absolute: 0.01, reason: for this test}
  tilt_shift: {absolute: 0.01, reason: for this test}
  bow: {absolute: 0.01, reason: for this test}
  bow_shift: {absolute: 0.01, reason: for this test}
"""
TRUTH = """
version: 1
scenes: {card: {card: {mean_radiance.red: {value: 0.5, formula: d E / pi, source: a book}}}}
"""


@pytest.fixture
def card(tmp_path: Path) -> Loaded:
    """A scene with its own references beside it."""
    folder = tmp_path / "project"
    (folder / "references").mkdir(parents=True)
    (folder / "references" / "thresholds.yaml").write_text(RULES)
    (folder / "references" / "analytic.yaml").write_text(TRUTH)
    (folder / "card.yaml").write_text(CARD)
    return load(folder / "card.yaml")


def run(
    tmp_path: Path,
    scenes: list[Loaded],
    tracer: FormulaEngine | None = None,
    povray: FormulaEngine | None = None,
    **rest,
) -> Results:
    engines = {"tracer": tracer or FormulaEngine("tracer"), "povray": povray or FormulaEngine("povray")}
    return compare(scenes, Request(out=tmp_path / "out", engines=engines, quality="draft", **rest))


def only(results: Results) -> SceneResult:
    (scene,) = results.scenes
    return scene


def test_equal_engines_agree_with_each_other_and_with_the_formula(tmp_path: Path, card: Loaded) -> None:
    results = run(tmp_path, [card])
    scene = only(results)
    assert (results.verdict, results.exit_code, scene.status) == (Verdict.AGREES, 0, Status.JUDGED)
    pairs = {entry.pair for entry in scene.observations[0].comparisons}
    assert pairs == {Pair.TRACER_POVRAY, Pair.TRACER_TRUTH, Pair.POVRAY_TRUTH}
    assert results.false_alarms.comparisons == len(scene.observations[0].comparisons)
    assert read_results(tmp_path / "out" / "results.json") == results


def test_the_engine_that_is_wrong_is_named(tmp_path: Path, card: Loaded) -> None:
    results = run(tmp_path, [card], tracer=FormulaEngine("tracer", radiance=0.55))
    observation = only(results).observations[0]
    assert (results.verdict, results.exit_code) == (Verdict.DEVIATES, 1)
    assert observation.attribution is not None and observation.attribution.engine == "tracer"
    deviating = {entry.pair for entry in observation.comparisons if entry.verdict is Verdict.DEVIATES}
    assert deviating == {Pair.TRACER_POVRAY, Pair.TRACER_TRUTH}


def test_noise_is_doubt_and_says_how_many_more_samples_decide(tmp_path: Path, card: Loaded) -> None:
    results = run(tmp_path, [card], tracer=FormulaEngine("tracer", noise=2.0))
    assert (results.verdict, results.exit_code) == (Verdict.INCONCLUSIVE, 5)
    doubtful = [e for e in only(results).observations[0].comparisons if e.verdict is Verdict.INCONCLUSIVE]
    assert any(entry.sample_factor and entry.sample_factor > 1 for entry in doubtful)


def test_doubt_buys_samples_and_only_for_the_scene_in_doubt(tmp_path: Path, card: Loaded) -> None:
    other = card.path.with_name("other.yaml")
    other.write_text(CARD.replace("Grey card", "Second card"))
    tracer = FormulaEngine("tracer", noise=0.1, noisy="Second card")
    results = run(tmp_path, [card, load(other)], tracer=tracer, rounds=2, budget_s=1e6)
    assert results.exit_code == 0, "the samples that were bought decide"
    sure, doubtful = results.scenes
    assert not sure.purchases and len(doubtful.purchases) in (1, 2)
    view = doubtful.observations[0].view
    assert view is not None and view.samples == doubtful.purchases[-1].samples["card"] > 1
    # The picture is that of the first look; only the view was made again.
    assert [image.exr for image in doubtful.images] == ["other/tracer.exr", "other/povray.exr"]
    assert f"look_{1 + len(doubtful.purchases)}" in view.images[0].exr
    assert (tmp_path / "out" / view.images[0].exr).is_file()
    # The engines claim 4 CPU s a look whatever it asks of them, and that is what the record says.
    assert results.prices is not None and results.prices.paid_s == 4.0 * results.prices.bought
    # Three looks at every number count as three comparisons.
    numbers = sum(len(each.comparisons) for scene in results.scenes for each in scene.observations)
    assert results.false_alarms.comparisons == 3 * numbers


def test_doubt_that_outlasts_the_rounds_stays_doubt(tmp_path: Path, card: Loaded) -> None:
    tracer = FormulaEngine("tracer", noise=2.0, stays_noisy=True)
    results = run(tmp_path, [card], tracer=tracer, rounds=1, budget_s=1e9)
    assert (results.verdict, tracer.renders) == (Verdict.INCONCLUSIVE, 2)


def test_doubt_that_costs_more_than_its_bound_buys_nothing_and_says_the_price(tmp_path: Path, card: Loaded) -> None:
    tracer = FormulaEngine("tracer", noise=2.0)
    scene = only(run(tmp_path, [card], tracer=tracer, rounds=3, budget_s=10.0))
    assert (scene.verdict, tracer.renders) == (Verdict.INCONCLUSIVE, 1)
    wish = scene.more_samples
    assert wish is not None and not wish.affordable and wish.cpu_s is not None and wish.cpu_s > wish.budget_s == 10.0
    # The first look is no purchase.
    assert "10 of the 10 CPU s" in wish.reason


def test_doubt_that_a_purchase_did_not_lessen_is_not_bought_again(tmp_path: Path, card: Loaded) -> None:
    stays = FormulaEngine("tracer", noise=0.1, stays_noisy=True)
    scene = only(run(tmp_path, [card], tracer=stays, rounds=3, budget_s=1000.0))
    assert (len(scene.purchases), stays.renders) == (1, 2)
    assert scene.more_samples is not None and not scene.more_samples.affordable


def test_a_number_that_comes_and_goes_with_the_noise_is_not_taken_for_exact() -> None:
    from vitrail.judge.observe import _steady
    from vitrail.metrics.measurement import Measurement, StudentInterval

    known = Measurement("r50", 1.0, "m", 1.0, interval=StudentInterval.about(1.0, 0.1, 5, 0.95, "draws"))
    lost = Measurement("r90", 1.0, "m", 1.0)
    noisy, quiet = _Samples(noise=np.ones(1)), _Samples(noise=None)
    assert _steady(Pair.TRACER_POVRAY, [known, lost], [noisy, quiet]) == (  # type: ignore[list-item]
        [known],
        ["tracer-vs-povray: r90 comes and goes with the noise"],
    )
    assert _steady(Pair.TRACER_POVRAY, [lost], [quiet, quiet]) == ([lost], [])  # type: ignore[list-item]


@dataclass
class _Samples:
    noise: np.ndarray | None


def test_a_failing_engine_stops_its_scene_and_no_other(tmp_path: Path, card: Loaded) -> None:
    other = card.path.with_name("other.yaml")
    other.write_text(CARD)
    povray = FormulaEngine("povray", script=["Parse Error: it is quoted"])
    results = run(tmp_path, [card, load(other)], povray=povray)
    assert [scene.status for scene in results.scenes] == [Status.ENGINE_FAILED, Status.JUDGED]
    assert "Parse Error: it is quoted" in results.scenes[0].message
    assert [scene.exit_code for scene in results.scenes] == [4, 0]
    assert results.exit_code == 4 and results.verdict is Verdict.AGREES


def test_a_bad_pixel_fails_before_anything_is_measured(tmp_path: Path, card: Loaded) -> None:
    def spoil(image: np.ndarray) -> np.ndarray:
        image[3, 5, 2] = np.nan
        return image

    scene = only(run(tmp_path, [card], tracer=FormulaEngine("tracer", spoil=spoil)))
    assert (scene.status, scene.exit_code) == (Status.ENGINE_FAILED, 4)
    assert "nan at pixel x=5 y=3 (channel B)" in scene.message
    assert scene.observations == ()


def test_an_interruption_keeps_what_has_finished_and_goes_on_from_there(tmp_path: Path, card: Loaded) -> None:
    other = card.path.with_name("other.yaml")
    other.write_text(CARD.replace("Grey card", "Second card"))
    scenes = [card, load(other)]
    tracer = FormulaEngine("tracer", script=["", "interrupt"])
    stopped = run(tmp_path, scenes, tracer=tracer)
    assert stopped.run.interrupted and stopped.exit_code == 130
    assert [scene.name for scene in stopped.scenes] == ["card"]
    # The second time the first scene is taken from where it was kept.
    again = FormulaEngine("tracer")
    finished = run(tmp_path, scenes, tracer=again)
    assert [scene.name for scene in finished.scenes] == ["card", "other"]
    assert again.renders == 1 and finished.exit_code == 0


def test_jobs_change_nothing_but_the_time(tmp_path: Path, card: Loaded) -> None:
    others = [card]
    for name in "abc":
        path = card.path.with_name(f"{name}.yaml")
        path.write_text(CARD.replace("Grey card", name))
        others.append(load(path))
    one = run(tmp_path / "one", others)
    four = run(tmp_path / "four", others, jobs=4)
    assert one.scenes == four.scenes


def test_a_scene_that_observes_nothing_is_no_success(tmp_path: Path, card: Loaded) -> None:
    path = card.path.with_name("blind.yaml")
    path.write_text(CARD.split("observe:")[0])
    results = run(tmp_path, [load(path)])
    assert (only(results).status, results.exit_code) == (Status.SCENE_ERROR, 2)
    assert "observes nothing" in only(results).message


def test_a_patch_outside_the_picture_is_said(tmp_path: Path, card: Loaded) -> None:
    path = card.path.with_name("aside.yaml")
    path.write_text(CARD.replace("center: [0, 0, 0], u", "center: [0.55, 0, 0], u"))
    results = run(tmp_path, [load(path)], views=False)
    assert results.exit_code == 2
    assert "% of its patch is in the frame" in only(results).message


def test_unusable_references_fail_before_anything_is_rendered(tmp_path: Path, card: Loaded) -> None:
    (card.path.parent / "references" / "thresholds.yaml").write_text(RULES + "  flux: {relative: 1}\n")
    tracer = FormulaEngine("tracer")
    with pytest.raises(Exception, match="flux has no reason"):
        run(tmp_path, [card], tracer=tracer)
    (card.path.parent / "references" / "thresholds.yaml").write_text(RULES)
    (card.path.parent / "references" / "analytic.yaml").write_text(TRUTH.replace("card: {card:", "card: {gone:"))
    with pytest.raises(ReferencesError, match="which the scene does not observe"):
        run(tmp_path, [card], tracer=tracer)
    assert tracer.renders == 0


def test_rates_are_per_cpu_second_and_compared(tmp_path: Path, card: Loaded) -> None:
    scene = only(run(tmp_path, [card]))
    tracer, povray = scene.engines
    assert (tracer.photons_per_cpu_s, povray.photons_per_cpu_s) == (10_000, 2000)
    assert [speed.ratio for speed in scene.speed] == [5.0, 1.0]


def test_a_defect_reaches_the_engine_and_the_reproduce_line(tmp_path: Path, card: Loaded) -> None:
    seen = []
    defect = Defect("spoiled", tracer=lambda lowered: seen.append(lowered["title"]) or {**lowered, "title": "spoiled"})
    scene = only(run(tmp_path, [card], defect=defect))
    assert seen == ["Grey card"]
    assert scene.reproduce.endswith("--inject-defect spoiled")


def test_scenes_of_one_name_get_folders_of_their_own() -> None:
    paths = [Path("/a/x.yaml"), Path("/b/x.yaml"), Path("/b/y.yaml"), Path("/c/b/x.yaml")]
    assert scene_names(paths) == ["a-x", "b-x", "y", "b-x-3"]


def test_photons_of_one_engine_that_all_went_astray_are_a_failure() -> None:
    """100 expected photons are the limit: by chance none of them is met with e^-100."""
    tracer = {"counters": {"photons_emitted": 10_000, "photons_stored": 1_000}}
    for emitted, stored in ((900, 0), (5000, 1), (0, 0)):
        check_photons(tracer, {"counters": {"photons_emitted": emitted, "photons_stored": stored}})
    check_photons({"counters": {**tracer["counters"], "photons_stored": 0}}, {"counters": {"photons_emitted": 5000}})
    with pytest.raises(EngineFailure, match="stored none, where the tracer stored 1000 of 10000"):
        check_photons(tracer, {"counters": {"photons_emitted": 5000, "photons_stored": 0}})


def test_a_scene_without_light_is_no_failure_of_an_engine(tmp_path: Path, card: Loaded) -> None:
    results = run(tmp_path, [card], tracer=FormulaEngine("tracer", 0.0), povray=FormulaEngine("povray", 0.0))
    assert (only(results).status, results.exit_code) == (Status.SCENE_ERROR, 2)
    assert only(results).message.startswith("no light reaches what the camera sees")
    results = run(tmp_path / "one", [card], povray=FormulaEngine("povray", 0.0))
    assert (only(results).status, results.exit_code) == (Status.ENGINE_FAILED, 4)


def test_what_an_engine_warns_of_is_a_remark_of_the_scene(tmp_path: Path, card: Loaded) -> None:
    results = run(tmp_path, [card], tracer=FormulaEngine("tracer", warnings=("light fell between beams",)))
    assert "tracer: light fell between beams" in only(results).warnings
