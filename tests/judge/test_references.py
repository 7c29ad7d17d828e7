"""Closed forms are read strictly: what the file names must exist, and what it says must be complete."""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.judge.reference_files import ReferencesError
from vitrail.judge.references import read_scene_truth, references_folder
from vitrail.judge.thresholds import read_thresholds, thresholds_of
from vitrail.scene.load import load, load_text
from vitrail.scene.model import Scene

ROOT = Path(__file__).parents[2]

SCENE = """
vitrail: 1
camera: {kind: orthographic, position: [0, 1, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}
image: {width: 8, height: 8}
materials: {card: {diffuse: 0.5}}
objects: [{name: card, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}]
lights: [{name: sun, directional: {direction: [0, -1, 0], irradiance: 1}}]
observe: [{name: card, phenomenon: diffusion, patch: {center: [0, 0, 0], u: [0.2, 0, 0], v: [0, 0, -0.2]}}]
"""


def scene() -> Scene:
    return load_text(SCENE).scene


def truth_in(folder: Path, text: str):
    (folder / "analytic.yaml").write_text("version: 1\nscenes:\n  card:\n" + text)
    return read_scene_truth(folder, "card", scene())


def test_a_value_comes_with_its_formula_and_its_tolerances(tmp_path: Path) -> None:
    text = """
    card:
      context: {annulus_edges_m: [0, 1, 2]}
      mean_radiance.red:
        value: 0.5
        formula: d E / pi
        source: "[O 1.1]"
        tolerance: {relative: 0.01, reason: rounding}
        povray: {absolute: 0.02, reason: half floats}
"""
    found = truth_in(tmp_path, text)
    (entry,) = found.of("card")
    assert (entry.metric, entry.value, entry.origin) == ("mean_radiance.red", 0.5, "d E / pi [O 1.1]")
    tracer, povray = entry.tolerance("tracer"), entry.tolerance("povray")
    assert tracer is not None and tracer.amount == pytest.approx(0.005)
    assert povray is not None and (povray.amount, povray.reason) == (0.02, "half floats")
    assert found.context("card").annulus_edges_m == (0, 1, 2)
    assert found.of("elsewhere") == ()


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("    other: {flux: {value: 1, formula: f, source: s}}\n", "card has truths for other, which the scene"),
        ("    card: {flux: {value: 1, formula: f}}\n", "card.card.flux: lacks source"),
        ("    card: {flux: {value: high, formula: f, source: s}}\n", "flux.value: is 'high'"),
        ("    card: {flux: {value: .nan, formula: f, source: s}}\n", "."),
        (
            "    card: {flux: {value: 1, formula: f, source: s, tolerance: {relative: -1, reason: r}}}\n",
            "at or above 0",
        ),
        ("    card: {flux: {value: 1, formula: f, source: s, tolerance: {absolute: yes, reason: r}}}\n", "."),
        ("    card: {flux: {value: 1, formula: f, source: s, tolerance: {absolute: .nan, reason: r}}}\n", "."),
        ("    card: {flux: 3}\n", "flux: is 3; write value"),
        ("    card: {context: {centre: [0, 0]}}\n", "context: knows .*, not {'centre'}"),
        ("    card: {flux: {value: 1, formula: f, source: s, tolerance: {relative: 1}}}\n", "and a `reason`"),
        ("    card: {profile: {along: u, positions_m: [1, 2], values: [1]}}\n", "2 positions for 1 values"),
        ("    card: {}\n    card: {}\n", "card"),
    ],
)
def test_a_gap_or_a_slip_in_the_file_fails(tmp_path: Path, text: str, says: str) -> None:
    with pytest.raises(ReferencesError, match=says):
        truth_in(tmp_path, text)


def test_a_scene_without_closed_forms_is_no_error(tmp_path: Path) -> None:
    assert read_scene_truth(tmp_path, "card", scene()).of("card") == ()


def test_every_published_truth_belongs_to_a_scene_and_is_measured_by_it() -> None:
    """A reference that is listed and cannot be used fails here, before anything is rendered."""
    from vitrail.scene.yaml_tree import read_yaml

    named = read_yaml((ROOT / "references" / "analytic.yaml").read_text())[0]["scenes"]
    files = {path.stem: path for path in (ROOT / "scenes").rglob("*.yaml")}
    for name in named:
        assert name in files, f"references/analytic.yaml has truths for {name}, and no scene file has that name"
        loaded = load(files[name])
        assert any(read_scene_truth(ROOT / "references", name, loaded.scene).of(o.name) for o in loaded.scene.observe)


def test_the_references_nearest_to_the_scene_count(tmp_path: Path) -> None:
    own = tmp_path / "project" / "references"
    own.mkdir(parents=True)
    assert references_folder(tmp_path / "project" / "scenes" / "x.yaml") == own
    assert references_folder(tmp_path / "project" / "scenes" / "x.yaml", tmp_path) == tmp_path
    with pytest.raises(ReferencesError, match="there is no such folder"):
        references_folder(tmp_path / "x.yaml", tmp_path / "nowhere")


def test_a_scene_of_another_project_never_meets_our_references(tmp_path: Path) -> None:
    """A copy of our ball lens, changed by its owner, must not be held against our closed form for it."""
    copy = tmp_path / "ball_lens.yaml"
    copy.write_text(SCENE)
    assert references_folder(copy) == tmp_path / "references"
    assert read_scene_truth(references_folder(copy), "ball_lens", scene()).of("card") == ()


def test_a_project_without_thresholds_has_ours(tmp_path: Path) -> None:
    assert thresholds_of(tmp_path) == read_thresholds(ROOT / "references" / "thresholds.yaml")
    (tmp_path / "thresholds.yaml").write_text("suite_false_alarm_rate: {value: 0.05}\n")
    assert thresholds_of(tmp_path).suite_false_alarm_rate == 0.05
