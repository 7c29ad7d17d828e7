"""Where a path ends: POV-Ray has one counter for what a scene counts apart."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.lower.povray.real_povray import LOOKING_DOWN, lowered, rendered, scene
from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.lost_light import LostLight

pytestmark = pytest.mark.povray

PIPE = "- {name: pipe, box: {min: [0, 0, -0.5], max: [4, 0.5, 0.5]}, material: glass}"
PANEL = "- {name: panel, rectangle: {center: [4.01, 0, 0], u: [0, 4, 0], v: [0, 0, 4]}, material: panel}"
MATERIALS = "glass: {transmission: 1, ior: 1.5}\npanel: {emission: 1}"


@pytest.mark.parametrize("most", [2, 4, 5, 6])
def test_light_in_a_pipe_meets_as_many_faces_as_the_scene_allows(most: int) -> None:
    """Unfolded: a ray that enters at y with the slope t is totally reflected at floor((y + 4 t) / 0.5) walls
    before it gets out: these and the two ends are its transmissions."""
    sine = 0.615
    slope = (sine / 1.5) / math.sqrt(1 - (sine / 1.5) ** 2)
    # Look at the end face at this angle, 64 rows of it.
    way = np.array([math.sqrt(1 - sine**2), sine, 0.0])
    position = np.array([0.0, 0.25, 0.0]) - 2 * way
    height = 0.5 * math.sqrt(1 - sine**2)
    camera = (
        f"camera: {{kind: orthographic, position: {position.tolist()}, look_at: [0, 0.25, 0],"
        f" up: [0, 1, 0], height: {height}}}"
    )
    image, limits = "image: {width: 4, height: 64}", f"transport: {{max_transmissions: {most}}}"
    loaded = scene(MATERIALS, f"{PIPE}\n{PANEL}", lights="", camera=camera, image=image, more=limits)
    entry = 0.5 - (np.arange(64) + 0.5) / 64 * 0.5
    walls = np.floor((entry + 4 * slope) / 0.5)
    clear = abs((entry + 4 * slope) / 0.5 - np.round((entry + 4 * slope) / 0.5)) > 0.02
    expected = (walls + 2 <= most).astype(float)
    assert walls.min() == 3 and walls.max() == 4
    assert rendered(loaded).image.radiance[clear, 1, 0] == pytest.approx(expected[clear], abs=1e-3)


def test_where_the_counter_is_longer_than_the_scene_allows_the_certificate_names_the_weight_of_such_a_path() -> None:
    second = PIPE.replace("pipe", "other").replace("0, 0, -0.5", "0, 1, -0.5").replace("4, 0.5, 0.5", "4, 1.5, 0.5")
    limits = "transport: {max_reflections: 3, max_transmissions: 10}"
    for shares, expected in (
        ("reflection: 0.2, transmission: 0.7", {"at most 3 reflections": 0.2**4, "at most 10 transmissions": 0.9**11}),
        ("transmission: 0.9, fresnel: true", {"at most 3 reflections": 0.9**4, "at most 10 transmissions": 0.9**11}),
        # What mirrors only totally has one counter in the scene, too.
        ("transmission: 0.9", {}),
    ):
        materials = MATERIALS.replace("transmission: 1", shares)
        certificate = lowered(scene(materials, f"{PIPE}\n{second}\n{PANEL}", more=limits)).certificate
        entries = [entry for entry in certificate.of(Phenomenon.REFRACTION) if "at most" in entry.source_law]
        assert {entry.source_law: entry.residual for entry in entries} == pytest.approx(expected)
        # They say what one path may weigh, not how many there are, so they widen no tolerance.
        assert {entry.unit for entry in entries} <= {"of a path"}
        assert certificate.bound(Phenomenon.REFRACTION) < 0.001


def test_mirrors_that_face_each_other_show_each_other_as_often_as_the_scene_allows() -> None:
    """Two mirrors of share 1/2 and a glowing panel between them: its images are dimmer by halves, and then none."""
    materials = "mirror: {reflection: 0.5}\npanel: {emission: 1}"
    objects = """
    - {name: left, rectangle: {center: [-1, 0, 0], u: [0, 4, 0], v: [0, 0, 4]}, material: mirror}
    - {name: right, rectangle: {center: [1, 0, 0], u: [0, 4, 0], v: [0, 0, 4]}, material: mirror}
    - {name: panel, rectangle: {center: [0, 0, -2], u: [1, 0, 0], v: [0, 2, 0]}, material: panel}
    """
    # Looking at 75 degrees to the depth, the way to the panel, 3 m deep, leads 11.2 m aside: 5 or 6 mirrors.
    way = np.array([math.sin(math.radians(75)), 0, -math.cos(math.radians(75))])
    camera = (
        f"camera: {{kind: orthographic, position: [0, 0, 1], look_at: {(np.array([0, 0, 1]) + way).tolist()},"
        " up: [0, 1, 0], height: 0.02}"
    )
    image = "image: {width: 2, height: 2}"
    aside = 3 * math.tan(math.radians(75))
    mirrors = math.floor((aside + 1) / 2)
    for most, expected in ((mirrors, 0.5**mirrors), (mirrors - 1, 0.0)):
        limits = f"transport: {{max_reflections: {most}}}"
        seen = rendered(
            scene(materials, objects, lights="", camera=camera, image=image, more=limits), quality="reference"
        )
        assert seen.mean[0] == pytest.approx(expected, rel=1e-3, abs=1e-9)


def test_light_that_has_to_cross_an_infinite_plane_arrives_nowhere() -> None:
    """POV-Ray's photons end at the plane, too: the plan knows it, and asks for none."""
    objects = """
    - {name: roof, plane: {point: [0, 3, 0], normal: [0, -1, 0]}, material: card}
    - {name: ball, sphere: {center: [0, 1, 0], radius: 0.5}, material: glass}
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}
    """
    camera = "camera: {position: [0, 2, 3], look_at: [0, 0, 0], fov_deg: 40}"
    seen = rendered(scene("glass: {transmission: 1, ior: 1.5}\ncard: {diffuse: 0.8}", objects, camera=camera))
    assert seen.lowered.photons is None and seen.image.radiance.max() == 0


def test_weak_branches_that_many_faces_cut_are_told() -> None:
    """A pile of panes shows less than Stokes's (1 - R) / (1 + (2 N - 1) R), and the run record says up to how much."""
    for count, is_told in ((1, False), (12, True)):
        panes = "\n".join(
            f"- {{name: p{k}, box: {{min: [-1, {0.2 * k + 0.1}, -1], max: [1, {0.2 * k + 0.2}, 1]}}, material: glass}}"
            for k in range(count)
        )
        seen = rendered(
            scene(
                "glass: {transmission: 1, ior: 1.7, fresnel: true}\nwall: {emission: 1}",
                "- {name: wall, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: wall}\n" + panes,
                lights="",
                camera=LOOKING_DOWN.replace("position: [0, 1, 0]", "position: [0, 4, 0]"),
                image="image: {width: 1, height: 1}",
            )
        )
        mirrored = (0.7 / 2.7) ** 2
        lost = (1 - mirrored) / (1 + (2 * count - 1) * mirrored) - seen.mean[0]
        assert (lost > 0.01) == is_told
        assert any("weak light were cut" in each for each in seen.record["warnings"]) == is_told


def test_no_path_goes_deeper_than_the_stack_of_povray() -> None:
    """A furnace where paths have 250 levels: without a limit POV-Ray ends with a segmentation fault."""
    seen = rendered(
        scene(
            "glass: {transmission: 1, ior: 1.33, fresnel: true}\nheavy: {transmission: 1, ior: 1.7, fresnel: true}",
            """
            - {name: block, box: {min: [-1, -1, -1], max: [1, 1, 1]}, material: glass}
            - {name: ball, sphere: {center: [0.1, 0, 0], radius: 0.8}, material: heavy, priority: 1}
            """,
            lights="- {name: sky, environment: {radiance: 1}}",
            camera="camera: {position: [1.5, 2, 5], look_at: [0, 0, 0], fov_deg: 30}",
            image="image: {width: 24, height: 24}",
            more="transport: {max_reflections: 100, max_transmissions: 150}",
        )
    )
    assert seen.image.radiance == pytest.approx(1, abs=0.02)
    deepest = [each for each in seen.lowered.certificate.entries if each.unit == "levels"]
    assert "limit of 176" in deepest[0].target_law


def test_a_view_adds_to_what_the_certificate_states_of_weak_branches_and_counts_none_twice() -> None:
    found = lowered(scene(MATERIALS, f"{PIPE}\n{PANEL}", lights=""))
    (stated,) = [entry.residual for entry in found.certificate.entries if "weights above" in entry.target_law]
    least = found.adc_bailout
    assert LostLight(dropped=stated, least_branch=least).unstated == pytest.approx(0, abs=least**1.5)
    assert LostLight(dropped=2 * stated, least_branch=least).unstated == pytest.approx(stated, rel=1e-3)
