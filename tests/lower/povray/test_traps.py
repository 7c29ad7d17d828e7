"""The traps of POV-Ray 3.7 that scenes of this back end can meet, each shown in plain scene text and avoided in ours.

Numbers in brackets are those of our notes on POV-Ray, section 12 [P 12].
"""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, lowered, plain_povray, rendered, scene
from vitrail.lower.povray import NotTranslatable

pytestmark = pytest.mark.povray

FLOOR_AND_PANE = """
- {{name: floor, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: floor}}
- {{name: pane, box: {{min: [-{w}, {a}, -{w}], max: [{w}, {b}, {w}]}}, material: pane}}
"""
CLEAR = "floor: {diffuse: 0.8}\npane: {transmission: 1, ior: 1.5}"


def below_pane(scale: float = 1.0) -> str:
    return (
        f"camera: {{kind: orthographic, position: [0, {scale}, 0], look_at: [0, 0, 0], up: [0, 0, -1],"
        f" height: {1.6 * scale}}}"
    )


def test_bright_and_large_scenes_keep_their_caustic_where_plain_text_loses_it() -> None:
    """[P 12.1] A photon of flux 32 or more vanishes without a word; a whole scene then looks lit by nothing."""
    plain = """#version 3.7;
    global_settings { assumed_gamma 1 photons { spacing 2 radius 40 gather 0, 100000 autostop 1 } }
    #default { finish { ambient 0 diffuse 0 } }
    camera { orthographic location <0, 99, 0> direction -y right <160, 0, 0> up <0, 0, 160> }
    light_source { <0, 1e4, 0> rgb BRIGHTNESS parallel point_at 0 }
    plane { y, 0 pigment { rgb 0.8 } finish { diffuse 1 } }
    box { <-200, 150, -200>, <200, 160, 200> pigment { rgb 1 filter 1 } interior { ior 1.5 }
      photons { target refraction on reflection off collect off } }"""
    assert plain_povray(plain.replace("BRIGHTNESS", "1"))[16, 16, 0] == pytest.approx(0.8, rel=0.05)
    assert plain_povray(plain.replace("BRIGHTNESS", "9"))[16, 16, 0] == 0
    big = scene(
        CLEAR,
        FLOOR_AND_PANE.format(w=200, a=150, b=160),
        "- {name: sun, directional: {direction: [0, -1, 0], irradiance: 28274.3}}",
        below_pane(100),
    )
    seen = rendered(big, photons=30_000)
    assert seen.mean[0] == pytest.approx(0.8 * 28274.3 / math.pi, rel=0.01)


@pytest.mark.parametrize("photons", [5, 1000, 100_000])
@pytest.mark.parametrize("irradiance", [1e-6, 1.0, 1e9])
def test_no_photon_ever_carries_what_povray_cannot_store(photons: int, irradiance: float) -> None:
    """[P 12.1] Colour times spacing squared stays below 32 in every run, however few photons share the light."""
    light = f"- {{name: sun, directional: {{direction: [0, -1, 0], irradiance: {irradiance}}}}}"
    made = lowered(scene(CLEAR, FLOOR_AND_PANE.format(w=9, a=15, b=16), light, below_pane(10)), photons=photons)
    for run in made.runs:
        assert run.photon_sdl is not None
        colour = float(re.search(r"light_source \{ <[^>]*> rgb ([\d.e+-]+)", run.photon_sdl)[1])
        spacing = float(re.search(r"spacing ([\d.e+-]+)", run.photon_sdl)[1])
        assert 0 < colour * spacing**2 <= 16


def test_an_empty_photon_map_is_never_a_picture() -> None:
    """[P 12.2] Plain text lets light straight through glass when no photon is stored; zero photons are refused."""
    plain = """#version 3.7;
    global_settings { assumed_gamma 1 max_trace_level 2 photons { spacing 0.1 radius 1 gather 0, 100000 } }
    #default { finish { ambient 0 diffuse 0 } }
    camera { orthographic location <0, 9, 0> direction -y right <9, 0, 0> up <0, 0, 9> }
    light_source { <0, 1e4, 0> rgb 1 parallel point_at 0 }
    plane { y, 0 pigment { rgb 0.8 } finish { diffuse 1 } }
    box { <-9, 10, -9>, <9, 11, 9> pigment { rgb 0.5 filter 1 } interior { ior 1.5 }
      photons { target refraction on reflection off collect off } }"""
    # The trace level is one too low, the picture looks right, and nothing was said.
    assert plain_povray(plain)[16, 16, 0] == pytest.approx(0.2, rel=HALF_FLOAT)
    with pytest.raises(NotTranslatable, match="without photons"):
        lowered(scene(CLEAR, FLOOR_AND_PANE.format(w=1, a=1.5, b=1.6), camera=below_pane()), photons=0)


def test_dim_channels_are_not_rounded_away() -> None:
    """[P 12.3] Photons keep 8 bits of the brightest channel; ours run one channel at a time."""
    light = "- {name: sun, directional: {direction: [0, -1, 0], irradiance: [3.14159265, 0.314159265, 0.00942477796]}}"
    seen = rendered(scene(CLEAR, FLOOR_AND_PANE.format(w=1, a=1.5, b=1.6), light, below_pane()), photons=100_000)
    assert seen.lowered.mode.name == "channels"
    assert seen.mean == pytest.approx(0.8 * np.array([1, 0.1, 0.003]), rel=3e-3)


def test_the_kernel_neither_shrinks_to_its_neighbours_nor_grows() -> None:
    """[P 12.4] The sum over a disc of fixed radius: flux through a hole in a roof, and nothing where nothing falls.

    An opaque roof with a clear window of 0.2 x 0.2: the projected window's flux is its area.
    """
    objects = """
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: floor}
    - {name: window, box: {min: [-0.1, 1.5, -0.1], max: [0.1, 1.6, 0.1]}, material: pane}
    - {name: west, box: {min: [-3, 1.4, -3], max: [-0.101, 1.7, 3]}, material: black}
    - {name: east, box: {min: [0.101, 1.4, -3], max: [3, 1.7, 3]}, material: black}
    - {name: north, box: {min: [-0.1009, 1.4, -3], max: [0.1009, 1.7, -0.101]}, material: black}
    - {name: south, box: {min: [-0.1009, 1.4, 0.101], max: [0.1009, 1.7, 3]}, material: black}
    """
    image = "image: {width: 64, height: 64}"
    room = scene(CLEAR + "\nblack: {}", objects, camera=below_pane(), image=image)
    seen = rendered(room, photons=100_000, gather_radius_m=0.05)
    flux = seen.image.radiance[..., 0].sum() * (1.6 / 64) ** 2 / 0.8
    # 1 %: the lattice of photons at the window's edges.
    assert flux == pytest.approx(0.04, rel=0.01)
    # Beyond window and disc there is exactly nothing: no search that widens.
    y, x = (np.mgrid[0:64, 0:64] + 0.5) * 1.6 / 64 - 0.8
    assert seen.image.radiance[np.maximum(abs(x), abs(y)) > 0.18].max() == 0


def test_clear_glass_in_front_of_glass_keeps_the_caustic() -> None:
    """[P 12.5] A clear pane that is no target kills the photons behind it; all our glass is a target."""
    objects = (
        FLOOR_AND_PANE.format(w=1, a=1.5, b=1.6)
        + "- {name: second, box: {min: [-1, 1.8, -1], max: [1, 1.9, 1]}, material: pane}"
    )
    seen = rendered(scene(CLEAR, objects, camera=below_pane()), photons=100_000)
    assert seen.mean[0] == pytest.approx(0.8, rel=2e-3)


def test_photons_meet_each_face_of_diffuse_glass_once() -> None:
    """[P 12.6] Layered textures filter photons twice; ours must project t^2, with d and r in the same material."""
    materials = "floor: {diffuse: 0.8}\npane: {diffuse: [0.3, 0.2, 0.1], transmission: [0.2, 0.4, 0.6], ior: 1.5}"
    seen = rendered(scene(materials, FLOOR_AND_PANE.format(w=1, a=1.5, b=1.6), camera=below_pane()), photons=100_000)
    assert seen.mean == pytest.approx(0.8 * np.array([0.04, 0.16, 0.36]), rel=3e-3)


def test_stacks_deeper_than_the_default_levels_are_not_black() -> None:
    """[P 12.7] The defaults of 5 levels and 1/255 turn a stack of panes black."""
    panes = "\n".join(
        f"- {{name: p{k}, box: {{min: [-9, {0.1 + k * 0.06}, -9], max: [9, {0.13 + k * 0.06}, 9]}}, material: pane}}"
        for k in range(10)
    )
    objects = "- {name: panel, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: panel}\n" + panes
    seen = rendered(scene("panel: {emission: 1}\npane: {transmission: 0.7, ior: 1.5}", objects, lights=""))
    assert seen.mean[0] == pytest.approx(0.7**20, rel=HALF_FLOAT)


def test_total_reflection_keeps_the_share_of_the_material() -> None:
    """[P 12.9] POV-Ray mirrors totally without colour. A light pipe: two faces crossed, one total turn between them."""
    objects = """
    - {name: prism, box: {min: [-1, -1, -9], max: [1, 1, 9]}, rotate_deg: [0, 0, 45], material: pipe}
    - {name: panel, plane: {point: [-5, 0, 0], normal: [1, 0, 0]}, material: panel}
    """
    # A ray straight down near the right edge enters at 45 degrees, is turned at the lower right face and leaves level.
    camera = "camera: {kind: orthographic, position: [1.2, 6, 0], look_at: [1.2, 0, 0], up: [0, 0, -1], height: 0.01}"
    for share in (0.8, 1.0):
        material = f"panel: {{emission: 1}}\npipe: {{transmission: {share}, ior: 2.5}}"
        seen = rendered(scene(material, objects, lights="", camera=camera))
        assert seen.image.radiance == pytest.approx(share**3, rel=HALF_FLOAT)


def test_a_fresnel_material_of_less_than_full_pool_keeps_both_shares() -> None:
    """[P 12.9] s R mirrored, s (1 - R) transmitted: a slab against a glowing panel, all bounces."""
    s, reflectance = 0.6, 0.04
    objects = """
    - {name: panel, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: panel}
    - {name: slab, box: {min: [-4, 0.5, -4], max: [4, 0.9, 4]}, material: glass}
    """
    material = "panel: {emission: 1}\nglass: {transmission: 0.5, reflection: 0.1, ior: 1.5, fresnel: true}"
    through = (s * (1 - reflectance)) ** 2 / (1 - (s * reflectance) ** 2)
    assert rendered(scene(material, objects, lights="")).mean[0] == pytest.approx(through, rel=HALF_FLOAT)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_lengths_far_from_one_unit_change_nothing(size: float) -> None:
    """[P 12.12] Tolerances of POV-Ray are absolute: the scene is brought to its size and back."""
    s = size
    objects = f"""
    - {{name: floor, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: panel}}
    - {{name: slab, box: {{min: [{-2 * s}, {0.5 * s}, {-2 * s}], max: [{2 * s}, {0.6 * s}, {2 * s}]}}, material: glass}}
    """
    camera = f"camera: {{kind: orthographic, position: [0, {s}, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: {s}}}"
    material = "panel: {emission: 1}\nglass: {transmission: 0.5, ior: 1.5}"
    assert rendered(scene(material, objects, lights="", camera=camera)).mean[0] == pytest.approx(0.25, rel=HALF_FLOAT)


def test_a_thin_pane_keeps_both_faces_or_is_refused() -> None:
    """[P 12.12] Below 1e-4 units one face of a pane is lost in plain text."""
    material = "panel: {emission: 1}\nglass: {transmission: 0.5, ior: 1.5}"
    objects = """
    - {{name: panel, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: panel}}
    - {{name: slab, box: {{min: [-2, 0.5, -2], max: [2, {top!r}, 2]}}, material: glass}}
    """
    thin = scene(material, objects.format(top=0.5 + 1e-5), lights="")
    assert rendered(thin).mean[0] == pytest.approx(0.25, rel=HALF_FLOAT)
    thinner = scene(material, objects.format(top=0.5 + 1e-8), lights="")
    with pytest.raises(NotTranslatable, match="scene.yaml:.*1e-08 m.*absolute tolerances"):
        lowered(thinner)


def test_a_ball_on_a_table_stands_a_hair_above_it() -> None:
    """[P 12.12] Light that meets two faces nearer than 1e-4 units misses one; a touch in a point becomes a gap."""
    objects = """
    - {name: panel, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: panel}
    - {name: ball, sphere: {center: [0, 0.5, 0], radius: 0.5}, material: glass}
    """
    made = lowered(scene("panel: {emission: 1}\nglass: {transmission: 0.5, ior: 1.5}", objects, lights=""))
    (gap,) = [entry for entry in made.certificate.entries if str(entry.item) == "`ball`" and "gap" in entry.target_law]
    assert 0 < gap.residual < 1e-2


def test_a_scene_far_from_the_origin_keeps_its_photons() -> None:
    """[P 12.13] Photon positions are single precision; the scene is moved to the origin."""
    far = 1e7
    objects = f"""
    - {{name: floor, rectangle: {{center: [{far}, 0, 0], u: [1, 0, 0], v: [0, 0, -1]}}, material: floor}}
    - {{name: pane, box: {{min: [{far - 1}, 1.5, -1], max: [{far + 1}, 1.6, 1]}}, material: pane}}
    """
    camera = (
        f"camera: {{kind: orthographic, position: [{far}, 1, 0], look_at: [{far}, 0, 0], up: [0, 0, -1], height: 1.2}}"
    )
    seen = rendered(scene(CLEAR, objects, camera=camera), photons=100_000)
    assert seen.mean[0] == pytest.approx(0.8, rel=2e-3)
    assert seen.image.variance.max() > 0


def test_shadow_rays_stop_at_glass_where_photons_bring_the_light() -> None:
    """[P 12.16] Shadow rays ignore Fresnel; the light under a Fresnel pane is that of the photons alone."""
    materials = "floor: {diffuse: 0.8}\npane: {transmission: 1, ior: 1.5, fresnel: true}"
    seen = rendered(scene(materials, FLOOR_AND_PANE.format(w=1, a=1.5, b=1.6), camera=below_pane()), photons=100_000)
    # 0.3 %: the lattice of photons; the main path's flux is stored exactly, the bounces in the pane are 0.2 % of all.
    assert seen.mean[0] == pytest.approx(0.8 * 0.96**2 / (1 - 0.04**2), rel=3e-3)


def test_two_renderings_are_the_same_bits() -> None:
    """[P 12.17] Photons differ with the number of threads; ours have one each, and a repaired tree."""
    pane = scene(CLEAR, FLOOR_AND_PANE.format(w=1, a=1.5, b=1.6), camera=below_pane())
    first, second = rendered(pane, photons=20_000), rendered(pane, photons=20_000)
    assert np.array_equal(first.image.radiance, second.image.radiance)


def test_the_default_finish_gives_no_light() -> None:
    """[P 12.18] Default ambient 0.1 and diffuse 0.6: a material that says nothing is black."""
    assert (
        rendered(scene("black: {}", "- {name: f, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: black}")).mean[
            0
        ]
        == 0
    )


def test_a_parallel_light_names_its_words_in_the_order_the_parser_takes() -> None:
    """[P 12.18] ``point_at`` before ``parallel`` is a parse error."""
    card = scene("card: {diffuse: 0.5}", "- {name: c, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}")
    for run in lowered(card).runs:
        assert re.search(r"light_source \{.*parallel point_at", run.sdl, re.DOTALL)
