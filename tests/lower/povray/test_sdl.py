"""What may reach a scene text: numbers that survive single precision, fixed words, and nothing from the scene file."""

from __future__ import annotations

import math
import re

import pytest

from tests.lower.povray.real_povray import LOOKING_DOWN, lowered, scene
from vitrail.lower.povray import NotTranslatable
from vitrail.lower.povray.text.edit import found
from vitrail.lower.povray.text.printer import UnwritableNumber, UnwritableWord, number, printed
from vitrail.lower.povray.text.sdl import Block, Directive, Product, Quoted, SdlFile, block, statement


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


@pytest.mark.parametrize("word", ["", "rgb 1 }", "Ball", "#include", "a\nb", "*/", "über", '"x"'])
def test_words_that_are_none_of_the_language_are_never_written(word: str) -> None:
    for part in (statement(word), block(word, statement("hollow")), Directive(word, 1), statement(Product(2, word))):
        with pytest.raises(UnwritableWord):
            printed(SdlFile((part,)))


@pytest.mark.parametrize("name", ["../x.exr", 'x" }', "a b", "", "x\n", "/etc/passwd"])
def test_file_names_that_are_none_of_ours_are_never_written(name: str) -> None:
    with pytest.raises(UnwritableWord):
        printed(SdlFile((statement("load_file", Quoted(name)),)))


def test_each_layer_of_a_look_from_inside_is_one() -> None:
    """A second `texture` in the place of an `interior_texture` would lie on the outside as a third layer."""
    glass = "tinted: {diffuse: 0.2, transmission: [0.2, 0.5, 0.8], ior: 1.5}"
    pane = "- {name: pane, box: {min: [-1, 0, -1], max: [1, 0.1, 1]}, material: tinted}"
    run = lowered(scene(glass, pane), reference_mode="native").runs[0]
    (box,) = found(run.pictures[0].scene, "box")
    assert [part.head for part in box.parts if isinstance(part, Block) and "texture" in part.head] == [
        *["texture"] * 2,
        *["interior_texture"] * 2,
    ]


def test_layers_in_nested_glass_are_refused_with_their_line() -> None:
    """POV-Ray 3.7 ends with a parse error where an object's pattern holds a layered texture."""
    materials = "tinted: {diffuse: 0.2, transmission: [0.2, 0.5, 0.8], ior: 1.5}\nwater: {transmission: 1, ior: 1.33}"
    objects = """
    - {name: tank, box: {min: [-1, 0, -1], max: [1, 1, 1]}, material: water}
    - {name: ball, sphere: {center: [0, 0.5, 0], radius: 0.3}, material: tinted, priority: 1}
    """
    nested = scene(materials, objects)
    with pytest.raises(NotTranslatable, match=r"scene.yaml:9:.*scatters inside other glass"):
        lowered(nested, reference_mode="native")
    assert lowered(nested, reference_mode="channels").runs
