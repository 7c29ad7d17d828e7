"""Lamps inside glass: what POV-Ray shoots from there, and what it cannot dim."""

from __future__ import annotations

import math

import pytest

from tests.lower.povray.real_povray import lowered, plain_povray, rendered, scene
from vitrail.lower.povray import NotTranslatable

pytestmark = pytest.mark.povray


def test_a_lamp_in_the_middle_of_a_ball_keeps_its_photons() -> None:
    """Light leaves a ball along its normals: E = I t omega / area, omega = 4 asin(a^2 / (a^2 + h^2)) of a square.

    POV-Ray spaces photons by the lamp's distance from the middle of the ball, and from there shoots five [P 2.1].
    """
    objects = """
    - {name: card, rectangle: {center: [0, 0, 0], u: [0, 0, 1], v: [1, 0, 0]}, material: card}
    - {name: ball, sphere: {center: [0, 1, 0], radius: 0.4}, material: glass}
    """
    lamp = "- {name: lamp, point: {position: [0, 1, 0], intensity: 5}}"
    camera = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.2}"
    glass = "card: {diffuse: 0.8}\nglass: {transmission: 0.5, ior: 1.5}"
    seen = rendered(scene(glass, objects, lamp, camera), photons=500_000, gather_radius_m=0.02)
    omega = 4 * math.asin(0.1**2 / (0.1**2 + 1))
    # 2 %: of 1300 photons on the card seen, one to a cell, only those of the cells on its edge are left to chance.
    assert seen.mean[0] == pytest.approx(0.8 / math.pi * 5 * 0.5 * omega / 0.2**2, rel=0.02)
    assert [entry.unit for entry in seen.lowered.certificate.entries if "middle of glass" in entry.source_law] == ["m"]


BOX = "box: {min: [-5, -0.5, -5], max: [5, 2, 5]}"
SEA = "plane: {point: [0, 2, 0], normal: [0, 1, 0]}"
CARD = "rectangle: {center: [0, 0, 0], u: [0, 0, 3], v: [3, 0, 0]}"
SPOT = "spot: {position: [0, 1, 0], direction: [0, -1, 0], intensity: 3, cone_deg: 100}"
FAR = "rectangle: {center: [0, 9, 0], u: [1, 0, 0], v: [0, 0, 1]}"


@pytest.mark.parametrize(
    ("water", "card", "lamp", "is_refused"),
    [
        (BOX, "box: {min: [-3, -0.2, -3], max: [3, -0.1, 3]}", SPOT, True),
        (BOX, "box: {min: [-3, -2.1, -3], max: [3, -2, 3]}", SPOT, False),
        (BOX, CARD, "point: {position: [0, 1, 0], intensity: 3}", True),
        (BOX, CARD, "area: {rectangle: {center: [0, 1, 0], u: [1, 0, 0], v: [0, 0, 1]}, radiance: 3}", True),
        (BOX, CARD, "area: {disc: {center: [0, 1, 0], normal: [0, -1, 0], radius: 1}, radiance: 3}", True),
        (BOX, CARD, "area: {rectangle: {center: [5.5, 1, 0], u: [1, 0, 0], v: [0, 0, 1]}, radiance: 3}", True),
        (BOX, CARD, f"area: {{{FAR}, radiance: 3}}", False),
        (BOX, CARD, f"area: {{{FAR}, collimated: true, irradiance: 3}}", False),
        (BOX, CARD, "directional: {direction: [0, -1, 0], irradiance: 3}", False),
        (BOX, "plane: {point: [9, 0, 0], normal: [0, 1, 0]}", SPOT, True),
        (BOX, "plane: {point: [0, -0.5, 0], normal: [0, 1, 0]}", SPOT, True),
        (BOX, "plane: {point: [0, -2, 0], normal: [0, 1, 0]}", SPOT, False),
        (BOX, "box: {min: [-9, -0.6, -9], max: [9, -0.5, 9]}", SPOT, True),
        (SEA, "plane: {point: [0, 0, 0], normal: [0, 1, 0]}", SPOT, True),
        (SEA, "plane: {point: [40, 4, 0], normal: [-0.1, 1, 0]}", SPOT, True),
        (SEA, "plane: {point: [0, 3, 0], normal: [0, -1, 0]}", SPOT, False),
    ],
)
def test_a_lamp_that_lights_a_surface_through_absorbing_glass_is_refused(
    water: str, card: str, lamp: str, is_refused: bool
) -> None:
    """POV-Ray dims light from face to face, and not between a lamp and a surface that share a medium [P 7]."""
    objects = f"- {{name: card, {card}, material: card}}\n- {{name: water, {water}, material: water}}"
    loaded = scene(
        "card: {diffuse: 0.8}\nwater: {transmission: 1, ior: 1.33, absorption_per_m: 1}",
        objects,
        f"- {{name: lamp, {lamp}}}",
    )
    if is_refused:
        with pytest.raises(NotTranslatable, match=r"scene\.yaml:11:\d+: POV-Ray does not dim the light of `lamp`"):
            lowered(loaded)
    else:
        lowered(loaded)


def test_a_lamp_in_absorbing_glass_that_scatters_is_refused() -> None:
    ball = "- {name: ball, sphere: {center: [0, 0, 0], radius: 0.4}, material: milk}"
    lamp = "- {name: lamp, point: {position: [0, 0, 0], intensity: 5}}"
    milk = "milk: {diffuse: 0.5, transmission: 0.5, ior: 1.5, absorption_per_m: 1}"
    with pytest.raises(NotTranslatable, match="inside the absorbing `ball`"):
        lowered(scene(milk, ball, lamp))


def test_light_inside_a_medium_is_not_dimmed_by_povray() -> None:
    """What the refusals are for, in hand-written text: a lamp a metre above a plane, both in absorbing glass."""
    text = """#version 3.7; global_settings {{ assumed_gamma 1 }} #default {{ finish {{ ambient 0 diffuse 0 }} }}
    camera {{ orthographic location y*0.5 look_at 0 up z*0.01 right x*0.01 sky z }}
    light_source {{ y rgb 1 fade_distance 1 fade_power 2 media_attenuation on }}
    plane {{ y, 0 hollow pigment {{ rgb 1 }} finish {{ diffuse 0.5 }} }}
    box {{ -5, 5 hollow pigment {{ rgbt 1 }} interior {{ media {{ absorption rgb {absorption} }} }} }}"""
    clear, dimmed = (plain_povray(text.format(absorption=each), 4, 4).mean() for each in (0, 1))
    # The camera's half metre is dimmed, the lamp's metre is not. 1e-3: half floats.
    assert dimmed / clear == pytest.approx(math.exp(-0.5), rel=1e-3)
