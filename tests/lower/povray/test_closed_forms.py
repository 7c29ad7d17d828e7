"""The real POV-Ray against formulas: cards, slabs, panes and the ball lens."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, LOOKING_DOWN, Rendered, rendered, rendered_file, scene

pytestmark = [pytest.mark.povray, pytest.mark.slow]


@pytest.mark.parametrize("tilt_deg", [0.0, 36.87, 75.0])
def test_a_grey_card_shows_albedo_times_irradiance_over_pi(tilt_deg: float) -> None:
    sine, cosine = math.sin(math.radians(tilt_deg)), math.cos(math.radians(tilt_deg))
    card = scene(
        "card: {diffuse: [0.05, 0.5, 0.95]}",
        "- {name: card, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}",
        f"- {{name: sun, directional: {{direction: [{sine}, {-cosine}, 0], irradiance: [3, 2, 0.5]}}}}",
    )
    expected = np.array([0.05, 0.5, 0.95]) * [3, 2, 0.5] * cosine / math.pi
    assert rendered(card).mean == pytest.approx(expected, rel=HALF_FLOAT)


def test_a_tilted_rectangle_and_a_turned_box_are_lit_by_their_cosine() -> None:
    """The camera sees the left half of a card that leans by 30 degrees, and the top of a box turned by 30 degrees."""
    objects = """
    - {name: c, rectangle: {center: [-0.5, 0, 0], u: [0.4, 0, 0], v: [0, 0, -1]}, rotate_deg: [30, 0, 0], material: m}
    - {name: box, box: {min: [0.1, -0.2, -0.5], max: [0.9, 0, 0.5]}, rotate_deg: [30, 0, 0], material: m}
    """
    camera = "camera: {kind: orthographic, position: [0, 3, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.4}"
    both = rendered(scene("m: {diffuse: 0.8}", objects, camera=camera, image="image: {width: 24, height: 8}"))
    left, right = both.image.radiance[2:6, 3:9], both.image.radiance[2:6, 15:21]
    assert left == pytest.approx(0.8 * math.cos(math.radians(30)), rel=HALF_FLOAT)
    assert right == pytest.approx(0.8 * math.cos(math.radians(30)), rel=HALF_FLOAT)


def test_a_point_light_falls_with_the_square_of_the_distance() -> None:
    card = rendered_file("scenes/calibration/grey_card_point.yaml", samples=4)
    view, height = math.tan(math.radians(20)) * 2, 2.0
    rows, columns = card.image.radiance.shape[:2]
    y, x = np.mgrid[0:rows, 0:columns]
    x = (2 * (x + 0.5) / columns - 1) * view * columns / rows
    y = (1 - 2 * (y + 0.5) / rows) * view
    expected = 0.18 / math.pi * 10 * height / (x**2 + y**2 + height**2) ** 1.5
    # Averaging over a pixel differs from its middle by (1/24) of the second difference, below 1e-5 here.
    assert card.image.radiance[..., 0] == pytest.approx(expected, rel=HALF_FLOAT + 1e-5)


@pytest.mark.parametrize(("name", "expected"), [("slab_normal", 0.923077), ("slab_tilted", 0.836230)])
def test_a_slab_transmits_what_fresnel_and_all_bounces_leave(name: str, expected: float) -> None:
    seen = rendered_file(f"scenes/calibration/{name}.yaml")
    assert seen.image.radiance == pytest.approx(expected, rel=HALF_FLOAT)


def test_a_tinted_pane_shows_t_squared_to_the_camera() -> None:
    seen = rendered_file("scenes/calibration/tinted_pane_seen.yaml")
    assert seen.mean == pytest.approx([0.81, 0.25, 0.04], rel=HALF_FLOAT)


def test_a_tinted_pane_projects_t_squared() -> None:
    """With photons on a lattice the mean over the patch is far better than their number suggests."""
    seen = rendered_file("scenes/calibration/tinted_pane_projected.yaml", photons=300_000, samples=1)
    assert seen.mean == pytest.approx([0.648, 0.2, 0.032], rel=1e-3)


def annulus_means(image: np.ndarray, half_width: float, edges: np.ndarray) -> np.ndarray:
    """Mean radiance of the annuli between ``edges`` (metres) around the middle of a square picture."""
    size = image.shape[0]
    y, x = (np.mgrid[0:size, 0:size] + 0.5 - size / 2) * (2 * half_width / size)
    radius = np.hypot(x, y)
    return np.array([image[(radius >= a) & (radius < b), 0].mean() for a, b in zip(edges[:-1], edges[1:], strict=True)])


def ball_lens_means(edges: np.ndarray, gather_radius: float) -> np.ndarray:
    """Mean of the disc-averaged closed form over annuli, by ray density: a ray at height b meets the floor at rho(b).

    Ball of radius 1 and n = 1.5 two radii above the floor, irradiance pi, albedo 0.8; no share of light is lost. Light
    that passes the ball falls on the floor directly, outside its shadow, and no disc averages it.
    """
    b = (np.arange(400_000) + 0.5) / 400_000
    incidence, inside = np.arcsin(b), np.arcsin(b / 1.5)
    turn = 2 * (incidence - inside)
    # Leave the ball at the angle 2 r - i below the middle's height, then go straight on.
    exit_x, exit_y = np.sin(2 * inside - incidence), -np.cos(2 * inside - incidence)
    rho = np.abs(exit_x - (2 + exit_y) * np.tan(turn))
    flux = 2 * math.pi * b / len(b)
    rng = np.random.default_rng(1)
    # Blur each ring of light by the disc: move its points by a random offset of the disc, many times over.
    found = np.zeros(len(edges) - 1)
    repeats = 20
    for _ in range(repeats):
        r, phi = gather_radius * np.sqrt(rng.random(len(b))), 2 * math.pi * rng.random(len(b))
        found += np.histogram(np.hypot(rho + r * np.cos(phi), r * np.sin(phi)), edges, weights=flux)[0] / repeats
    return 0.8 * found / (math.pi * np.diff(edges**2))


def test_the_ball_lens_has_the_annuli_of_its_closed_form() -> None:
    """2 %: pixels that straddle an annulus' edges, and photons that stay a lattice of 0.4 cells of jitter."""
    seen = rendered_file("scenes/calibration/ball_lens.yaml", photons=1_000_000, samples=4)
    edges = np.array([0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9])
    radius = seen.lowered.settings.gather_radius_m
    expected = ball_lens_means(edges, radius)
    assert annulus_means(seen.image.radiance, 1.3, edges) == pytest.approx(expected, rel=0.02)


def test_half_images_agree_within_their_own_variance() -> None:
    """The halves are two estimates of one image: their mean difference is zero within its spread."""
    seen = rendered_file("scenes/calibration/ball_lens.yaml", photons=300_000, samples=1)
    image = seen.image
    assert image.radiance == pytest.approx((image.half_a + image.half_b) / 2, abs=1e-6)
    assert image.variance == pytest.approx((image.half_a - image.half_b) ** 2 / 4, abs=1e-6)
    assert image.variance.mean() > 0
    difference = (image.half_a - image.half_b)[..., 0]
    assert abs(difference.mean()) < 4 * difference.std() / math.sqrt(difference.size)


def test_mirror_diffusion_and_glass_shares_add_up_for_camera_and_photons() -> None:
    """d, r and t are independent: a pane of each against panels that glow above and below it [P 4.2]."""
    material = "pane: {diffuse: [0.3, 0.2, 0.1], reflection: [0.05, 0.1, 0.15], transmission: [0.2, 0.4, 0.6], ior: 1}"
    objects = """
    - {name: pane, rectangle: {center: [0, 0, 0], u: [9, 0, 0], v: [0, 0, -9]}, material: pane}
    - {name: below, plane: {point: [0, -1, 0], normal: [0, 1, 0]}, material: glow}
    """
    camera = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}"
    # The sun lights the pane from above; the panel below shines through; nothing is there to be mirrored.
    seen = rendered(scene(f"{material}\nglow: {{emission: 2}}", objects, camera=camera))
    expected = np.array([0.3, 0.2, 0.1]) + 2 * np.array([0.2, 0.4, 0.6])
    assert seen.mean == pytest.approx(expected, rel=HALF_FLOAT)


def test_light_scattered_inside_glass_is_dimmed_by_the_square_of_its_index() -> None:
    """[O 1.1 row 10] A pane of d, r, t and index n lit and seen from above, all bounces between its faces.

    Outside: d. Inside: photons t / (1 - r^2) on the lower face and r times that on the upper one, scattered with d,
    seen through t with all bounces, over n^2. POV-Ray alone would leave out n^2.
    """
    d, r, t, n = 0.3, 0.1, 0.4, 1.5
    objects = "- {name: pane, box: {min: [-1, 0, -1], max: [1, 0.2, 1]}, material: opal}"
    camera = "camera: {kind: orthographic, position: [0, 3, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.6}"
    material = f"opal: {{diffuse: {d}, reflection: {r}, transmission: {t}, ior: {n}}}"
    lower, upper = t / (1 - r * r), t * r / (1 - r * r)
    expected = d + t * d * (lower + r * upper) / (1 - r * r) / n**2
    # 0.2 %: some 4000 photons in view make up a tenth of the light.
    assert rendered(scene(material, objects, camera=camera), photons=200_000).mean[0] == pytest.approx(
        expected, rel=2e-3
    )


@pytest.mark.parametrize("shares", ["transmission: 0.7", "transmission: 1", "transmission: 0.5, diffuse: 0.3"])
@pytest.mark.parametrize("fresnel", [True, False])
def test_glass_glows_at_both_faces_whatever_else_it_does(shares: str, fresnel: bool) -> None:
    """A pane over nothing: e of the face in front, and what both faces send inwards, e / n^2, with all bounces.

    L = e + T (e / n^2) / (1 - R), with R = s R_0 and T = s (1 - R_0) by Fresnel, else 0 and t; nothing is lit.
    """
    e, n, s = 0.2, 1.5, 0.5 if "0.5" in shares else 0.7 if "0.7" in shares else 1.0
    normal = ((n - 1) / (n + 1)) ** 2 if fresnel else 0.0
    expected = e + s * (1 - normal) * e / n**2 / (1 - s * normal)
    material = f"glow: {{{shares}, ior: {n}, fresnel: {str(fresnel).lower()}, emission: {e}}}"
    pane = "- {name: pane, box: {min: [-1, 0, -1], max: [1, 0.2, 1]}, material: glow}"
    assert rendered(scene(material, pane, lights="")).mean == pytest.approx([expected] * 3, rel=HALF_FLOAT)


def test_a_card_cast_into_glass_is_dimmed_by_the_square_of_its_index() -> None:
    """With t = 3/4 a flux of 255 / 256 after two faces has 8 bits after one, too: nothing is truncated [P 2.4]."""
    cast = card_in_glass(0.75)
    # 0.1 %: half floats, and the lattice of photons at a kernel of 0.047 m.
    assert cast.mean[0] == pytest.approx(0.8 * 0.75**2 / 1.5**2, rel=1e-3)


def test_photons_stored_after_one_face_are_truncated_as_the_certificate_says() -> None:
    cast = card_in_glass(0.9)
    (rounding,) = [entry for entry in cast.lowered.certificate.entries if "truncated" in entry.target_law]
    lost = 1 - cast.mean[0] / (0.8 * 0.9**2 / 1.5**2)
    assert 1e-3 < lost < rounding.residual


def card_in_glass(transmission: float) -> Rendered:
    objects = """
    - {name: block, box: {min: [-1, -0.5, -1], max: [1, 0.5, 1]}, material: glass}
    - {name: card, rectangle: {center: [0, 0, 0], u: [0.9, 0, 0], v: [0, 0, -0.9]}, material: card}
    """
    camera = "camera: {kind: orthographic, position: [0, 3, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.6}"
    materials = f"glass: {{transmission: {transmission}, ior: 1.5}}\ncard: {{diffuse: 0.8}}"
    return rendered(scene(materials, objects, camera=camera), photons=200_000)


def test_a_mirror_shows_its_share_of_what_it_faces() -> None:
    objects = """
    - {name: mirror, rectangle: {center: [0, 0, 0], u: [1, 0, 0], v: [0, 0, -1]}, material: mirror}
    - {name: sky, plane: {point: [0, 3, 0], normal: [0, -1, 0]}, material: glow}
    """
    seen = rendered(scene("mirror: {reflection: [0.9, 0.5, 0.1]}\nglow: {emission: 2}", objects, lights=""))
    assert seen.mean == pytest.approx([1.8, 1.0, 0.2], rel=HALF_FLOAT)


def test_constant_ambient_lights_every_diffuse_surface_by_its_irradiance() -> None:
    card = scene(
        "card: {diffuse: [0.2, 0.5, 0.8]}",
        "- {name: card, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}",
        more="transport: {indirect: {ambient: [1, 2, 3]}}",
    )
    expected = np.array([0.2, 0.5, 0.8]) * (1 + np.array([1, 2, 3]) / math.pi)
    assert rendered(card).mean == pytest.approx(expected, rel=HALF_FLOAT)


def test_beer_and_lambert_inside_a_slab() -> None:
    materials = "panel: {emission: 1}\nglass: {transmission: 1, ior: 1, absorption_per_m: [0.5, 2, 10]}"
    objects = """
    - {name: panel, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: panel}
    - {name: slab, box: {min: [-4, 0.2, -4], max: [4, 0.5, 4]}, material: glass}
    """
    seen = rendered(scene(materials, objects, lights="", camera=LOOKING_DOWN))
    assert seen.mean == pytest.approx(np.exp(-np.array([0.5, 2, 10]) * 0.3), rel=HALF_FLOAT)


def test_what_is_dark_beside_a_bright_panel_keeps_its_digits() -> None:
    """Half floats below 6e-5 lose bits; a factor on all light keeps 2e-3 beside 320 above that."""
    objects = """
    - {name: bright, rectangle: {center: [-0.5, 0, 0], u: [0.5, 0, 0], v: [0, 0, -1]}, material: bright}
    - {name: dark, rectangle: {center: [0.5, 0, 0], u: [0.5, 0, 0], v: [0, 0, -1]}, material: dark}
    """
    seen = rendered(scene("bright: {emission: 320}\ndark: {emission: 0.002}", objects, lights="")).image.radiance
    assert seen[16, 8, 0] == pytest.approx(320, rel=HALF_FLOAT)
    assert seen[16, 24, 0] == pytest.approx(0.002, rel=5e-4)
