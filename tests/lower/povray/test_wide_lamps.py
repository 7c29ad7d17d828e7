"""Lamps that are wide beside the distance of what they light: enough small lights, a stated error, or a refusal."""

from __future__ import annotations

import math

import pytest

from tests.lower.povray.real_povray import LOOKING_DOWN, lowered, rendered, scene
from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray import NotTranslatable
from vitrail.lower.povray.text.wide_lamps import CLOSEST, ERROR
from vitrail.scene.load import Loaded

pytestmark = pytest.mark.povray

CARD = "- {name: card, rectangle: {center: [0, 0, 0], u: [0.4, 0, 0], v: [0, 0, -0.4]}, material: white}"


def below(lamp: str, more: str = "") -> Loaded:
    """A white card of 0.8 m, seen from 0.5 m above, and a lamp of radiance 1 that shines down on it."""
    camera = LOOKING_DOWN.replace("position: [0, 1, 0]", "position: [0, 0.5, 0]").replace("height: 1", "height: 0.2")
    light = f"- {{name: lamp, area: {{{lamp}, radiance: 1}}}}"
    return scene("white: {diffuse: 1}", f"{CARD}\n{more}", light, camera)


def disc(radius: float) -> str:
    return f"disc: {{center: [0, 1, 0], normal: [0, -1, 0], radius: {radius}}}"


@pytest.mark.parametrize("radius", [1.0, 2.0, 4.0])
def test_a_card_under_a_disc_has_its_light(radius: float) -> None:
    """L R^2 / (R^2 + h^2) on the axis. 21 points at R = 4 h are spots of light: up to half too bright or too dark."""
    seen = rendered(below(disc(radius)), photons=0)
    allowed = 2 * ERROR * CLOSEST**2 + 0.01
    assert seen.image.radiance[14:18, 14:18].mean() == pytest.approx(radius**2 / (radius**2 + 1), rel=allowed)
    assert not [each for each in seen.lowered.certificate.entries if "as far apart" in each.target_law]


def test_a_card_under_a_wide_rectangle_has_its_light() -> None:
    """Under the middle of a square of half side a: 4 / pi s atan(s) with s = a / hypot(a, h), by its four corners."""
    a = 3.0
    lamp = f"rectangle: {{center: [0, 1, 0], u: [{a}, 0, 0], v: [0, 0, {a}]}}"
    part = a / math.hypot(a, 1)
    expected = 4 / math.pi * part * math.atan(part)
    seen = rendered(below(lamp))
    assert seen.image.radiance[14:18, 14:18].mean() == pytest.approx(expected, rel=0.03)


def test_where_the_most_small_lights_are_few_the_certificate_says_by_how_much() -> None:
    made = lowered(below(disc(8)))
    entries = [each for each in made.certificate.of(Phenomenon.DIFFUSION) if "as far apart" in each.target_law]
    step = math.sqrt(math.pi * 64 / 233)
    assert [each.residual for each in entries] == pytest.approx([ERROR * step**2], rel=1e-3)


def test_a_lamp_far_too_wide_is_refused_with_its_line() -> None:
    with pytest.raises(NotTranslatable, match=r"scene.yaml:\d+:\d+: `lamp` is so wide and lights what is so near, 1 m"):
        lowered(below(disc(25)))


@pytest.mark.parametrize(
    "roof",
    [
        "rectangle: {center: [0, 1.01, 0], u: [3, 0, 0], v: [0, 0, 3]}",
        "plane: {point: [0, 1.01, 0], normal: [0, -1, 0]}",
    ],
)
def test_what_lies_behind_a_lamp_needs_no_more_lights(roof: str) -> None:
    made = lowered(below(disc(0.3), f"- {{name: roof, {roof}, material: white}}"))
    assert made.runs[0].sdl.count("light_source") == 21


def test_the_certificate_says_how_far_the_spots_of_a_focused_sun_stand_apart() -> None:
    """Small suns share the solid angle evenly: a square of side d sqrt(pi / n) / 2 for each of n."""
    ball = "- {name: ball, sphere: {center: [0, 1.5, 0], radius: 0.3}, material: glass}"
    sun = "- {name: sun, directional: {direction: [0, -1, 0], irradiance: 1, angular_diameter_deg: 3}}"
    made = lowered(scene("white: {diffuse: 1}\nglass: {transmission: 1, ior: 1.5}", f"{CARD}\n{ball}", sun))
    entries = [each for each in made.certificate.entries if "spots in each half" in each.target_law]
    count = made.runs[0].sdl.count("light_source")
    assert [each.residual for each in entries] == pytest.approx([math.radians(1.5) * math.sqrt(math.pi / count)])
    assert made.certificate.bound(Phenomenon.CAUSTIC) < 0.1
