"""Lights with a surface or a solid angle, against their closed forms, in the real POV-Ray."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, lowered, rendered, scene
from vitrail.lower.povray.certificate.certificate import Named

pytestmark = pytest.mark.povray

CARD = "- {name: card, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}"
GREY = "card: {diffuse: 0.8}"
SPOT_OF_CARD = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.01}"


def test_a_disc_lamp_gives_its_form_factor() -> None:
    """Above a facing disc of radius R at height h: E = pi L R^2 / (R^2 + h^2). 0.3 %: 24 places on the lamp a half."""
    lamp = "- {name: lamp, area: {disc: {center: [0, 1, 0], normal: [0, -1, 0], radius: 0.5}, radiance: [1, 2, 3]}}"
    seen = rendered(scene(GREY, CARD, lamp, SPOT_OF_CARD))
    assert seen.mean == pytest.approx(0.8 * np.array([1, 2, 3]) * 0.25 / 1.25, rel=3e-3)


def test_a_rectangle_lamp_gives_its_form_factor() -> None:
    """Over a corner-symmetric facing rectangle a x b at height h, by the four quarter form factors."""
    lamp = "- {name: lamp, area: {rectangle: {center: [0, 1, 0], u: [0.4, 0, 0], v: [0, 0, 0.7]}, radiance: 1}}"
    seen = rendered(scene(GREY, CARD, lamp, SPOT_OF_CARD))
    x, y = 0.4, 0.7
    a, b = math.sqrt(1 + x * x), math.sqrt(1 + y * y)
    quarter = (x / a * math.atan(y / a) + y / b * math.atan(x / b)) / 2
    # The lamp shines along u x v, which here is -y, down.
    assert seen.mean[0] == pytest.approx(0.8 / math.pi * 4 * quarter, rel=3e-3)


def test_an_area_lamp_shines_on_one_side_only() -> None:
    lamp = "- {name: lamp, area: {disc: {center: [0, 1, 0], normal: [0, 1, 0], radius: 0.5}, radiance: 1}}"
    assert rendered(scene(GREY, CARD, lamp, SPOT_OF_CARD)).mean[0] == 0


@pytest.mark.parametrize(
    "shape",
    [
        "disc: {center: [0.1, 1, 0], normal: [0, -1, 0], radius: 0.3}",
        "rectangle: {center: [0.1, 1, 0], u: [0.3, 0, 0], v: [0, 0, 0.2]}",
    ],
)
def test_a_collimated_lamp_lights_its_own_outline(shape: str) -> None:
    """The paper's figure 4: all flux along the normal; the lit patch has the lamp's shape, size and irradiance."""
    lamp = f"- {{name: lamp, area: {{{shape}, collimated: true, irradiance: 3}}}}"
    camera = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}"
    image = rendered(scene(GREY, CARD, lamp, camera, "image: {width: 100, height: 100}")).image.radiance[..., 0]
    y, x = (np.mgrid[0:100, 0:100] + 0.5) / 100 - 0.5
    inside = np.hypot(x - 0.1, y) < 0.29 if "disc" in shape else (abs(x - 0.1) < 0.29) & (abs(y) < 0.19)
    outside = np.hypot(x - 0.1, y) > 0.31 if "disc" in shape else (abs(x - 0.1) > 0.31) | (abs(y) > 0.21)
    assert image[inside] == pytest.approx(0.8 * 3 / math.pi, rel=HALF_FLOAT)
    assert not image[outside].any()


def test_a_collimated_lamp_lights_nothing_behind_it_and_its_photons_start_at_it() -> None:
    """A card above the lamp stays dark; a pane below passes the lamp's light on."""
    objects = """
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}
    - {name: pane, box: {min: [-1, 0.4, -1], max: [1, 0.5, 1]}, material: glass}
    - {name: above, rectangle: {center: [0, 2, 0], u: [1, 0, 0], v: [0, 0, 1]}, material: card}
    """
    outline = "rectangle: {center: [0, 1, 0], u: [0.3, 0, 0], v: [0, 0, 0.3]}"
    lamp = f"- {{name: lamp, area: {{{outline}, collimated: true, irradiance: 3}}}}"
    camera = "camera: {kind: orthographic, position: [0, 0.2, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.4}"
    materials = GREY + "\nglass: {transmission: 0.5, ior: 1.5}"
    below = rendered(scene(materials, objects, lamp, camera), photons=50_000, gather_radius_m=0.02)
    # 1 %: photons at random in their cells, 40 a disc, over 300 discs' areas.
    assert below.mean[0] == pytest.approx(0.8 * 3 / math.pi * 0.25, rel=0.01)
    up = "camera: {kind: orthographic, position: [0, 1.5, 0], look_at: [0, 2, 0], up: [0, 0, -1], height: 0.4}"
    assert rendered(scene(materials, objects, lamp, up), photons=50_000).mean[0] == 0


def test_a_spot_has_a_sharp_edge_at_half_its_cone() -> None:
    lamp = "- {name: lamp, spot: {position: [0, 1, 0], direction: [0, -1, 0], intensity: 2, cone_deg: 40}}"
    camera = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}"
    image = rendered(scene(GREY, CARD, lamp, camera, "image: {width: 100, height: 100}")).image.radiance[..., 0]
    y, x = (np.mgrid[0:100, 0:100] + 0.5) / 100 - 0.5
    radius, edge = np.hypot(x, y), math.tan(math.radians(20))
    expected = 0.8 / math.pi * 2 / (1 + radius**2) ** 1.5
    assert image[radius < edge - 0.01] == pytest.approx(expected[radius < edge - 0.01], rel=HALF_FLOAT)
    assert not image[radius > edge + 0.01].any()


def test_a_spot_sends_its_light_through_glass() -> None:
    """Photons of a spot: a clear pane of index 1 changes nothing."""
    objects = CARD + "\n- {name: pane, box: {min: [-0.3, 0.6, -0.3], max: [0.3, 0.7, 0.3]}, material: air}"
    lamp = "- {name: lamp, spot: {position: [0, 1, 0], direction: [0, -1, 0], intensity: 2, cone_deg: 40}}"
    camera = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.2}"
    through = scene(GREY + "\nair: {transmission: 1, ior: 1}", objects, lamp, camera)
    seen = rendered(through, photons=100_000, gather_radius_m=0.03)
    y, x = (np.mgrid[0:32, 0:32] + 0.5) / 160 - 0.1
    expected = (0.8 / math.pi * 2 / (1 + x**2 + y**2) ** 1.5).mean()
    # 1 %: some 2000 photons in view.
    assert seen.mean[0] == pytest.approx(expected, rel=0.01)


def test_a_sun_keeps_its_irradiance_and_softens_its_shadows() -> None:
    """The half-shadow of an edge at height h is h times the sun's diameter wide."""
    objects = CARD + "\n- {name: roof, box: {min: [0, 1, -9], max: [9, 1.1, 9]}, material: card}"
    sun = "- {name: sun, directional: {direction: [0, -1, 0], irradiance: 3, angular_diameter_deg: 8}}"
    camera = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.4}"
    image = rendered(scene(GREY, objects, sun, camera, "image: {width: 80, height: 80}")).image.radiance[..., 0]
    row = image.mean(axis=0) / (0.8 * 3 / math.pi)
    half = math.tan(math.radians(4))
    x = (np.arange(80) + 0.5) / 200 - 0.2
    share = np.clip(x / half, -1, 1)
    lit = 0.5 - (np.arcsin(share) + share * np.sqrt(1 - share**2)) / math.pi
    # 21 small suns a half: now and then two of them set at the same place.
    assert row == pytest.approx(lit, abs=2 / 21)
    assert row[:20] == pytest.approx(1, rel=HALF_FLOAT)


def test_a_white_sky_lights_a_card_with_its_own_radiance() -> None:
    """A white Lambert surface under a constant sky is as bright as the sky.

    0.1 %: for a card that faces a pole of the lattice 89 directions a half err by 0.01 %; half floats add 0.05 %.
    """
    sky = "- {name: sky, environment: {radiance: [1, 2, 4]}}"
    seen = rendered(scene("card: {diffuse: 1}", CARD, sky, SPOT_OF_CARD))
    assert seen.mean == pytest.approx([1, 2, 4], rel=0.001)


def test_a_constant_sky_is_seen_and_mirrored() -> None:
    objects = "- {name: mirror, rectangle: {center: [0, 0, 0], u: [0.25, 0, 0], v: [0, 0, 9]}, material: mirror}"
    camera = "camera: {kind: orthographic, position: [0, 1, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}"
    sky = "- {name: sky, environment: {radiance: 2}}"
    image = rendered(scene("mirror: {reflection: 0.5}", objects, sky, camera)).image.radiance
    assert image[:, :6] == pytest.approx(2, rel=HALF_FLOAT)
    assert image[:, 12:20] == pytest.approx(1, rel=HALF_FLOAT)


def test_each_half_has_its_own_small_lights_and_the_certificate_counts_them() -> None:
    lamp = "- {name: lamp, area: {disc: {center: [0, 1, 0], normal: [0, -1, 0], radius: 0.5}, radiance: 1}}"
    made = lowered(scene(GREY, CARD, lamp, SPOT_OF_CARD))
    first, second = (run.sdl for run in made.runs)
    assert first != second and first.count("light_source") == second.count("light_source") > 20
    lamp_of = Named("light", "lamp")
    entry = next(each for each in made.certificate.entries if each.item == lamp_of and "small ones" in each.target_law)
    assert entry.residual == pytest.approx(1 / (2 * first.count("light_source")))
    fades = [each for each in made.certificate.entries if each.source_law == "E = I / r^2"]
    assert [str(each.item) for each in fades] == ["`lamp`"], "each small light loses a share of its own: no sum"
