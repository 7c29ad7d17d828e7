"""Rough faces and light between walls, in the real POV-Ray."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.lower.povray.real_povray import LOOKING_DOWN, SUN, Rendered, lowered, rendered, rendered_file, scene
from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray import NotTranslatable
from vitrail.lower.povray.text.roughness import LEVELS, TILT_PER_AMPLITUDE, bumps_of
from vitrail.scene.model import Ggx, Material

pytestmark = [pytest.mark.povray, pytest.mark.slow]


def behind_a_pane(roughness: str, samples: int = 64) -> Rendered:
    """An edge at x = 0, bright on the left, one metre behind a pane of 0.1 m with index 1.5."""
    materials = f"frosted: {{transmission: 1, ior: 1.5, roughness: {roughness}}}\nbright: {{emission: 1}}"
    objects = """
    - {name: pane, box: {min: [-2, -2, 0], max: [2, 2, 0.1]}, material: frosted}
    - {name: wall, rectangle: {center: [-3, 0, -1], u: [3, 0, 0], v: [0, 3, 0]}, material: bright}
    """
    camera = "camera: {kind: orthographic, position: [0, 0, 3], look_at: [0, 0, 0], height: 1}"
    image = "image: {width: 80, height: 40}"
    return rendered(scene(materials, objects, lights="", camera=camera, image=image), samples=samples)


def unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def equation_8(way: np.ndarray, roughness: float, rng: np.random.Generator) -> np.ndarray:
    """[S eq. 8] (1 - gamma) d + gamma rho, rho the part of a random unit vector across d, gamma = u lambda / 2."""
    random = unit(rng.normal(size=way.shape))
    across = random - (random * way).sum(axis=1, keepdims=True) * way
    gamma = rng.random((len(way), 1)) * roughness / 2
    return unit((1 - gamma) * way + gamma * across)


def walk_through_a_pane(roughness: float, count: int = 200_000) -> np.ndarray:
    """Where on the wall straight rays arrive after both faces, x in metres."""
    rng = np.random.default_rng(1)
    way = equation_8(np.tile([0.0, 0.0, -1.0], (count, 1)), roughness, rng)
    x = 0.1 * way[:, 0] / -way[:, 2]
    out = way * 1.5
    out[:, 2] = -np.sqrt(1 - out[:, 0] ** 2 - out[:, 1] ** 2)
    out = equation_8(out, roughness, rng)
    return x + out[:, 0] / -out[:, 2]


@pytest.mark.parametrize("roughness", [0.1, 0.3])
def test_frosting_blurs_an_edge_as_equation_8_does(roughness: float) -> None:
    """The width within the certificate's 6 %, the profile within 0.03: the lobe's shape is right to 0.01, and the
    aliases of bumps under a regular grid of samples add as much."""
    seen = behind_a_pane(str(roughness), samples=256)
    profile = seen.image.radiance[..., 0].mean(axis=0)
    x = np.linspace(-1, 1, 81)[:-1] + 1 / 80
    arrivals = walk_through_a_pane(roughness)
    expected = np.array([(place + arrivals < 0).mean() for place in x])
    assert profile == pytest.approx(expected, abs=0.03)

    def width(edge: np.ndarray) -> float:
        low, high = np.interp([0.1, 0.9], edge[::-1], x[::-1])
        return float(low - high)

    rough = [entry for entry in seen.lowered.certificate.of(Phenomenon.ROUGHNESS) if str(entry.item) == "`frosted`"]
    assert len(rough) == 1 and rough[0].residual == 0.06
    assert width(profile) == pytest.approx(width(expected), rel=0.06)


def test_half_images_differ_by_the_noise_of_the_bumps() -> None:
    """Means of 64 samples in the blurred edge: half a step at most over the root of 64, twice for the difference."""
    seen = behind_a_pane("0.3").image
    apart = np.abs(seen.half_a - seen.half_b)[..., 0]
    assert 0.01 < apart[:, 35:45].mean() < 2 * 0.5 / 8
    assert apart[:, :8].mean() < 0.005


def test_the_blurs_of_several_materials_are_off_by_no_more_than_the_worst_of_them() -> None:
    materials = """
    silk: {transmission: 1, ior: 1.5, roughness: 0.1}
    milk: {transmission: 1, ior: 1.5, roughness: 0.5}
    bright: {emission: 1}
    """
    objects = """
    - {name: first, box: {min: [-2, -2, 0], max: [2, 2, 0.1]}, material: silk}
    - {name: second, box: {min: [-2, -2, 0.2], max: [2, 2, 0.3]}, material: milk}
    - {name: wall, rectangle: {center: [-3, 0, -1], u: [3, 0, 0], v: [0, 3, 0]}, material: bright}
    """
    camera = "camera: {kind: orthographic, position: [0, 0, 3], look_at: [0, 0, 0], height: 1}"
    certificate = lowered(scene(materials, objects, lights="", camera=camera)).certificate
    first, second = (
        next(e for e in certificate.of(Phenomenon.ROUGHNESS) if str(e.item) == item) for item in ("`silk`", "`milk`")
    )
    image = next(e for e in certificate.of(Phenomenon.ROUGHNESS) if str(e.item) == "image")
    assert first.residual == 0.06 and second.residual == pytest.approx(0.08)
    assert certificate.bound(Phenomenon.ROUGHNESS) == pytest.approx(image.residual + 0.08)


def test_ggx_amplitudes_have_the_quantiles_of_its_slopes() -> None:
    """P(tan theta > x) = alpha^2 / (alpha^2 + x^2): a mixture of Rayleigh lobes of these mean squares."""
    glass = Material(transmission=1, ior=1.5, roughness=Ggx(ggx=0.2))
    bumps = bumps_of(glass, 1.5, from_inside=False)
    assert bumps is not None
    mean_squares = (np.array(bumps.amplitudes) * TILT_PER_AMPLITUDE) ** 2
    for slope in (0.05, 0.1, 0.2, 0.4):
        beyond = np.exp(-(slope**2) / mean_squares).mean()
        # The largest of 16 levels cut off the tail: 1/32 of the lobe.
        assert beyond == pytest.approx(0.04 / (0.04 + slope**2), abs=1 / (2 * LEVELS))


def test_a_smooth_face_has_no_bumps_and_rough_glass_has_an_inside_of_its_own() -> None:
    assert bumps_of(Material(transmission=1, ior=1.5), 1.5, from_inside=False) is None
    text = behind_text("0.2")
    assert "interior_texture" in text and text.count("bumps") == 4 * LEVELS
    assert "bumps" not in behind_text("0")


def behind_text(roughness: str) -> str:
    materials = f"frosted: {{transmission: 1, ior: 1.5, roughness: {roughness}}}\nbright: {{emission: 1}}"
    objects = """
    - {name: pane, box: {min: [-2, -2, 0], max: [2, 2, 0.1]}, material: frosted}
    - {name: wall, rectangle: {center: [-3, 0, -1], u: [3, 0, 0], v: [0, 3, 0]}, material: bright}
    """
    camera = "camera: {kind: orthographic, position: [0, 0, 3], look_at: [0, 0, 0], height: 1}"
    return lowered(scene(materials, objects, lights="", camera=camera)).runs[0].sdl


def test_roughness_without_a_refraction_to_carry_it_is_refused() -> None:
    materials = "frosted: {transmission: 1, ior: 1, roughness: 0.2}\nbright: {emission: 1}"
    objects = """
    - {name: pane, box: {min: [-2, -2, 0], max: [2, 2, 0.1]}, material: frosted}
    - {name: wall, rectangle: {center: [-3, 0, -1], u: [3, 0, 0], v: [0, 3, 0]}, material: bright}
    """
    camera = "camera: {kind: orthographic, position: [0, 0, 3], look_at: [0, 0, 0], height: 1}"
    with pytest.raises(NotTranslatable, match="normals tilted"):
        lowered(scene(materials, objects, lights="", camera=camera))


def test_a_closed_room_gains_one_over_one_minus_albedo() -> None:
    """0.2 %: bounces beyond the last, and a thousandth of half-float rounding."""
    seen = rendered_file("scenes/calibration/closed_room.yaml", quality="draft")
    assert seen.mean[0] == pytest.approx(1 / math.pi, rel=2e-3)


def test_light_that_radiosity_would_invent_is_refused() -> None:
    objects = """
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}
    - {name: wall, rectangle: {center: [0, 0, -1], u: [1, 0, 0], v: [0, 1, 0]}, material: glow}
    """
    materials = "card: {diffuse: 0.5}\nglow: {diffuse: 0.5, emission: 0.1}"
    glowing = scene(materials, objects, more="transport: {indirect: photons}")
    with pytest.raises(NotTranslatable, match="emission light other surfaces"):
        lowered(glowing)


def test_a_card_inside_glass_is_refused_beside_radiosity() -> None:
    objects = """
    - {name: floor, plane: {point: [0, -2, 0], normal: [0, 1, 0]}, material: card}
    - {name: block, box: {min: [-1, -1, -1], max: [1, 1, 1]}, material: glass}
    - {name: cast, rectangle: {center: [0, 0, 0], u: [0.5, 0, 0], v: [0, 0.5, 0]}, material: card}
    """
    materials = "card: {diffuse: 0.5}\nglass: {transmission: 1, ior: 1.5}"
    with pytest.raises(NotTranslatable, match=r"inside glass without the square"):
        lowered(scene(materials, objects, more="transport: {indirect: photons}"))
    standing = objects.replace("[0, -2, 0]", "[0, -1, 0]").replace("center: [0, 0, 0], u", "center: [0, 4, 0], u")
    with pytest.raises(NotTranslatable, match=r":8:.* inside glass without the square"):
        lowered(scene(materials, standing, more="transport: {indirect: photons}"))


@pytest.mark.parametrize(("roughness", "stated"), [("0", 0.0), ("0.3", 0.135), ("{ggx: 0.2}", 0.08)])
def test_the_certificate_says_how_far_bumps_spread_a_caustic(roughness: str, stated: float) -> None:
    text = scene(
        f"floor: {{diffuse: 0.5}}\nfrost: {{transmission: 0.9, ior: 1.5, roughness: {roughness}}}",
        "- {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: floor}\n"
        "- {name: ball, sphere: {center: [0, 2, 0], radius: 0.5}, material: frost}\n",
        SUN,
        LOOKING_DOWN,
    )
    entries = lowered(text, photons=1000).certificate.of(Phenomenon.CAUSTIC)
    assert sum(each.residual for each in entries if "bumps" in each.target_law) == pytest.approx(stated)
