"""Faces that lie on each other [P 12.12]: plain scene text loses one of them, or puts air between them.

What both engines mean: the radiance of a panel under glass is seen through the upper face only, less by the square of
the index; two glasses have one mirror between them, by their own indices, and both tints.
"""

from __future__ import annotations

from itertools import permutations

import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, LOOKING_DOWN, lowered, plain_povray, rendered, scene
from tests.lower.povray.test_bodies import face, slab, stack

MATERIALS = """
panel: {emission: 1}
glass: {transmission: 0.5, ior: 1.5}
flint: {transmission: 0.8, ior: 2}
crown: {transmission: 1, ior: 1.5, fresnel: true}
heavy: {transmission: 1, ior: 2, fresnel: true}
"""
PANELS = {
    "plane": "- {name: panel, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: panel}",
    "rectangle": "- {name: panel, rectangle: {center: [0, 0, 0], u: [4, 0, 0], v: [0, 0, -4]}, material: panel}",
    "box": "- {name: panel, box: {min: [-4, -1, -4], max: [4, 0, 4]}, material: panel}",
}


def seen(*bodies: str) -> float:
    made = rendered(scene(MATERIALS, "\n".join(bodies), lights="", camera=LOOKING_DOWN))
    assert made.image.radiance.std() < 1e-6
    return float(made.mean[0])


def test_plain_text_loses_the_face_that_glass_stands_on() -> None:
    plain = """#version 3.7;
    global_settings { assumed_gamma 1 max_trace_level 9 }
    #default { finish { ambient 0 diffuse 0 } }
    camera { orthographic location <0, 9, 0> direction -y right <1, 0, 0> up <0, 0, 1> }
    plane { y, 0 pigment { rgb 1 } finish { emission 1 } }
    box { <-9, 0, -9>, <9, 1, 9> pigment { rgb 0.5 filter 1 } interior { ior 1.5 } }"""
    # Neither with air below the glass (0.25) nor in contact (0.222).
    assert plain_povray(plain)[16, 16, 0] == pytest.approx(0.5, rel=HALF_FLOAT)


@pytest.mark.parametrize("panel", PANELS)
@pytest.mark.parametrize("priority", [0, 1])
def test_a_panel_under_glass_is_seen_from_inside_the_glass(panel: str, priority: int) -> None:
    bodies = [PANELS[panel], slab("a", 0, 0.5, "glass", priority)]
    assert seen(*bodies) == pytest.approx(0.5 / 1.5**2, rel=HALF_FLOAT)
    assert seen(*reversed(bodies)) == pytest.approx(0.5 / 1.5**2, rel=HALF_FLOAT)


@pytest.mark.parametrize("order", list(permutations(range(3)))[::2])
def test_two_tinted_panes_on_a_panel_keep_both_tints_at_their_common_face(order: tuple[int, ...]) -> None:
    bodies = [PANELS["plane"], slab("a", 0, 0.5, "glass"), slab("b", 0.5, 0.9, "flint")]
    expected = 0.8 * (0.8 * 0.5) / 1.5**2
    assert seen(*(bodies[index] for index in order)) == pytest.approx(expected, rel=HALF_FLOAT)


@pytest.mark.parametrize("priorities", [(0, 0), (1, 0), (0, 1)])
def test_two_clear_panes_mirror_once_where_they_meet(priorities: tuple[int, int]) -> None:
    """Air between them would leave 0.75 instead of 0.842."""
    bodies = [slab("a", 0, 0.5, "crown", priorities[0]), slab("b", 0.5, 0.9, "heavy", priorities[1])]
    below = PANELS["plane"].replace("[0, 0, 0]", "[0, -1, 0]")
    expected = stack([face(1, 1.5), face(1.5, 2), face(2, 1)])
    assert seen(below, *bodies) == pytest.approx(expected, rel=HALF_FLOAT)


def test_photons_land_on_the_table_inside_the_glass() -> None:
    """Light through the tinted upper face; what the table scatters leaves through it, less by n^2."""
    materials = "card: {diffuse: 0.5}\nglass: {transmission: 0.5, ior: 1.5}"
    bodies = [PANELS["plane"].replace("material: panel", "material: card"), slab("a", 0, 0.5, "glass")]
    sun = "- {name: sun, directional: {direction: [0, -1, 0], irradiance: 3.141592653589793}}"
    made = rendered(scene(materials, "\n".join(bodies), sun), photons=200_000)
    # Photons are counted in 8 bits: up to one step of 1/128 is lost.
    assert made.mean[0] == pytest.approx(0.5 * 0.5 * 0.5 / 1.5**2, rel=1 / 128)


def test_the_certificate_says_how_much_a_solid_grows() -> None:
    made = lowered(scene(MATERIALS, "\n".join([PANELS["plane"], slab("a", 0, 0.5, "glass")]), lights=""))
    (entry,) = [each for each in made.certificate.entries if "reaches into" in each.target_law]
    assert entry.item == "`a`" and 0 < entry.residual < 1e-2
    assert not [each for each in made.certificate.entries if "gap" in each.target_law]
