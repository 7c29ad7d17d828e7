"""The canonical text of a scene reads back as the same scene."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

from tests.scene.any_scene import scenes
from vitrail.scene.load import load, load_text
from vitrail.scene.model import Scene
from vitrail.scene.print import print_scene, scene_hash

SHIPPED = sorted(Path("scenes").rglob("*.yaml"))


@pytest.mark.slow
@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
@given(scenes())
def test_any_scene_survives_printing(scene: Scene) -> None:
    text = print_scene(scene)
    read = load_text(text).scene
    assert read == scene
    assert print_scene(read) == text


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_scenes_survive_printing(path: Path) -> None:
    scene = load(path).scene
    assert load_text(print_scene(scene)).scene == scene


def test_the_text_is_as_short_as_the_author_would_write_it() -> None:
    text = print_scene(load("scenes/calibration/tinted_pane_seen.yaml").scene)
    assert "  panel: {emission: 1}\n" in text
    assert "  pane: {transmission: [0.9, 0.5, 0.2], ior: 1.5}\n" in text
    assert "transport" not in text and "fresnel" not in text
    assert "lights: []\n" in text


def test_the_hash_follows_the_meaning_not_the_spelling() -> None:
    path = Path("scenes/calibration/ball_lens.yaml")
    text = path.read_text(encoding="utf-8")
    original = scene_hash(load(path).scene)
    assert scene_hash(load_text(text.replace("diffuse: 0.8", "diffuse: [0.8, 0.80, 8e-1]")).scene) == original
    assert scene_hash(load_text(text.replace("diffuse: 0.8", "diffuse: 0.80000001")).scene) != original
