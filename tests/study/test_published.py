"""What the documents say about the studies is what the stored result files say."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.study.published import ROOT, STUDIES, TRADEOFFS, published, words
from vitrail.base.engine_name import EngineName
from vitrail.pipeline.task_log import read_rows
from vitrail.report.atlas_page import finding
from vitrail.study.extremes.atlas import AXES, STACKS, write_scenes
from vitrail.study.tradeoff.analysis import TARGETS, analyse_rows
from vitrail.study.tradeoff.plan_study import analyse_plans
from vitrail.study.tradeoff.sentence import price_in_words


@pytest.mark.parametrize("name", TRADEOFFS)
def test_the_stored_analysis_is_that_of_the_stored_samples(name: str) -> None:
    stored = published(f"{name}/tradeoff.json")
    assert stored == analyse_rows(read_rows(STUDIES / name), stored.scene, stored.title)
    assert stored.failures == ()


def test_the_readme_has_the_prices_of_a_caustic() -> None:
    engines = published("ball_lens/tradeoff.json").phenomena["caustic"].engines
    for target in TARGETS:
        tracer, povray = (price_in_words(engines[name].price_s[str(target)]) for name in EngineName)
        assert f"| {100 * target:g} % | {tracer} | {povray} |" in words(ROOT / "README.md")


@pytest.mark.parametrize("name", TRADEOFFS)
def test_the_page_of_studies_quotes_every_sentence_and_links_every_study(name: str) -> None:
    page = words(STUDIES / "README.md")
    for entry in published(f"{name}/tradeoff.json").phenomena.values():
        assert entry.sentence in page
    assert f"({name}/" in page


def test_every_setting_has_its_memory_and_its_runs() -> None:
    for front in published("ball_lens/tradeoff.json").phenomena["caustic"].engines.values():
        for setting in front.settings:
            # A process that renders 128 x 128 pixels from at most 3e6 photons of 48 bytes: megabytes, no gigabyte.
            assert 1e6 < setting.peak_memory_bytes < 1e9
            assert setting.runs == 3


def test_the_plan_changes_nothing_and_is_never_slower() -> None:
    stored = published("plans/plans.json")
    assert stored == analyse_plans(read_rows(STUDIES / "plans"))
    shipped = {path.stem for path in (ROOT / "scenes").glob("*/*.yaml")}
    # Every scene there was when the study was published; a new scene need not wait for it.
    assert len(stored.scenes) >= 45 and {scene.name for scene in stored.scenes} <= shipped
    for scene in stored.scenes:
        assert scene.failure is None, scene.name
        whole = scene.differences["everything"]
        # Noise alone is 1 in these units; its own scatter over thousands of pixels is a few per cent.
        noisy = whole.sigmas is not None and whole.sigmas < 1.2 and whole.outside_noise < 1e-6
        assert whole.same_bits or noisy, scene.name
        assert not scene.slower, scene.name
    summary = stored.summary
    said = f"All {summary.scenes} scenes" if summary.same_bits == summary.scenes else f"{summary.same_bits} of"
    assert said in words(STUDIES / "README.md")


def test_the_atlas_has_every_axis_and_its_finding_is_quoted() -> None:
    atlas = published("atlas/atlas.json")
    assert [axis.name for axis in atlas.axes] == [axis.name for axis in AXES]
    assert finding(atlas) in words(STUDIES / "README.md")


def test_every_tracer_limit_of_the_atlas_has_its_reason() -> None:
    for axis in published("atlas/atlas.json").axes:
        for engine, found in axis.engines.items():
            assert found.failure is None
            if found.first_failing is None:
                continue
            assert engine == "povray" or found.limit, axis.name


def test_the_scenes_of_the_atlas_are_those_that_code_makes_and_stacks_are_left_out(tmp_path: Path) -> None:
    write_scenes(tmp_path, published("atlas/atlas.json"))
    made = {path.name: path.read_text() for path in tmp_path.iterdir()}
    kept = {path.name: path.read_text() for path in (STUDIES / "atlas" / "scenes").iterdir()}
    stacks = {name for name in made if name.rsplit("-", 1)[0] in STACKS}
    assert {name: text for name, text in kept.items() if name not in stacks} == {
        name: text for name, text in made.items() if name not in stacks
    }
    assert len(stacks) == 8 and max(len(text) for name, text in kept.items() if name not in stacks) < 2000
