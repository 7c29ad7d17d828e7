"""Lamps inside glass: what POV-Ray shoots from there, and what it cannot dim."""

from __future__ import annotations

import math

import pytest

from tests.lower.povray.real_povray import lowered, rendered, scene
from vitrail.lower.povray import NotTranslatable


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


@pytest.mark.parametrize(("depth", "is_refused"), [(-0.1, True), (-2.0, False)])
def test_a_lamp_beside_a_card_in_absorbing_glass_is_refused(depth: float, is_refused: bool) -> None:
    """POV-Ray dims light from face to face, and not between a lamp and a surface that share a medium [P 7]."""
    objects = f"""
    - {{name: card, box: {{min: [-3, {depth - 0.1}, -3], max: [3, {depth}, 3]}}, material: card}}
    - {{name: water, box: {{min: [-5, -0.5, -5], max: [5, 2, 5]}}, material: water}}
    """
    lamp = "- {name: lamp, spot: {position: [0, 1, 0], direction: [0, -1, 0], intensity: 3, cone_deg: 100}}"
    under = scene("card: {diffuse: 0.8}\nwater: {transmission: 1, ior: 1.33, absorption_per_m: 1}", objects, lamp)
    if is_refused:
        with pytest.raises(NotTranslatable, match="does not dim the light of `lamp`"):
            lowered(under)
    else:
        lowered(under)
