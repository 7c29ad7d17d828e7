"""What may reach a scene text: numbers that survive single precision, fixed words, and nothing from the scene file."""

from __future__ import annotations

import math
import re

import pytest

from tests.lower.povray.real_povray import LOOKING_DOWN, lowered, scene
from vitrail.lower.povray import NotTranslatable
from vitrail.lower.povray.text.sdl import UnwritableNumber, number


@pytest.mark.parametrize("value", [math.inf, -math.inf, math.nan, 1e39, -1e300])
def test_numbers_beyond_single_precision_are_never_written(value: float) -> None:
    """[P 12.20] 1e400 parses as infinity, without a word."""
    with pytest.raises(UnwritableNumber):
        number(value)


def test_hostile_names_never_reach_the_scene_text() -> None:
    """[P 8.5] Only numbers, fixed words and our own identifiers are written."""
    evil = r"x*/ } #include \"/etc/passwd\" //"
    hostile = scene(
        f'"{evil}": {{diffuse: 0.5}}',
        f'- {{name: "{evil}", plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: "{evil}"}}',
        f'- {{name: "{evil}", directional: {{direction: [0, -1, 0], irradiance: 1}}}}',
        more=f'title: "{evil}"',
    )
    for run in lowered(hostile).runs:
        assert "passwd" not in run.sdl and "#include" not in run.sdl and "*/" not in run.sdl
        assert set(re.findall(r"#\w+", run.sdl)) == {"#version", "#default"}


def test_what_has_no_counterpart_is_refused_with_its_line() -> None:
    objects = """
    - {name: mirror, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: mirror}
    - {name: card, rectangle: {center: [0, 0.5, 0], u: [0.1, 0, 0], v: [0, 0, -0.1]}, material: card}
    """
    endless = scene("mirror: {reflection: 0.5}\ncard: {diffuse: 0.5}", objects, camera=LOOKING_DOWN)
    with pytest.raises(NotTranslatable, match=r"scene.yaml:8:.*infinite plane; use a rectangle"):
        lowered(endless)
