"""Faces that lie on each other [P 12.12]: plain scene text loses one of them, or puts air between them.

What both engines mean: the radiance of a panel under glass is seen through the upper face only, less by the square of
the index; two glasses have one mirror between them, by their own indices, and both tints.
"""

from __future__ import annotations

from itertools import permutations
from pathlib import Path

import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, LOOKING_DOWN, lowered, plain_povray, rendered, scene
from tests.lower.povray.test_bodies import face, slab, stack
from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.flush import orders
from vitrail.scene.load import load

pytestmark = pytest.mark.povray

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


def mesh_slab(folder: Path, name: str, low: float, high: float, material: str, priority: int = 0) -> str:
    """The slab as twelve triangles in a file."""
    corners = [(x, y, z) for y in (low, high) for x, z in ((-4, 4), (4, 4), (4, -4), (-4, -4))]
    faces = ["1 4 3 2", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {face}" for face in faces]
    (folder / f"{name}.obj").write_text("\n".join(lines))
    file = f"{{file: {folder / name}.obj, smooth: false}}"
    return f"- {{name: {name}, mesh: {file}, material: {material}, priority: {priority}}}"


@pytest.mark.parametrize("panel", PANELS)
def test_a_mesh_on_a_panel_is_in_contact(panel: str, tmp_path: Path) -> None:
    block = mesh_slab(tmp_path, "a", 0, 0.5, "glass")
    assert seen(PANELS[panel], block) == pytest.approx(0.5 / 1.5**2, rel=HALF_FLOAT)


@pytest.mark.parametrize("priorities", [(0, 0), (0, 1)])
def test_two_cemented_meshes_of_one_glass_are_one_pane(priorities: tuple[int, int], tmp_path: Path) -> None:
    """Air between them would leave 0.857 instead of 0.923."""
    panes = [mesh_slab(tmp_path, name, low, low + 0.4, "crown", priority) for name, low, priority in
             (("a", 0, priorities[0]), ("b", 0.4, priorities[1]))]  # fmt: skip
    below = PANELS["plane"].replace("[0, 0, 0]", "[0, -1, 0]")
    expected = stack([face(1, 1.5), face(1.5, 1)])
    assert seen(below, *panes) == pytest.approx(expected, rel=HALF_FLOAT)


@pytest.mark.parametrize("low", [0.5, 0.4])
def test_meshes_of_two_glasses_mirror_once_where_they_meet_or_overlap(low: float, tmp_path: Path) -> None:
    panes = [mesh_slab(tmp_path, "a", 0, 0.5, "crown"), mesh_slab(tmp_path, "b", low, 0.9, "heavy", 1)]
    below = PANELS["plane"].replace("[0, 0, 0]", "[0, -1, 0]")
    expected = stack([face(1, 1.5), face(1.5, 2), face(2, 1)])
    assert seen(below, *panes) == pytest.approx(expected, rel=HALF_FLOAT)


def test_photons_land_on_the_table_inside_the_glass() -> None:
    """Light through the tinted upper face; what the table scatters leaves through it, less by n^2."""
    materials = "card: {diffuse: 0.5}\nglass: {transmission: 0.5, ior: 1.5}"
    bodies = [PANELS["plane"].replace("material: panel", "material: card"), slab("a", 0, 0.5, "glass")]
    sun = "- {name: sun, directional: {direction: [0, -1, 0], irradiance: 3.141592653589793}}"
    made = rendered(scene(materials, "\n".join(bodies), sun), photons=200_000)
    # Photons are counted in 8 bits: up to one step of 1/128 is lost.
    assert made.mean[0] == pytest.approx(0.5 * 0.5 * 0.5 / 1.5**2, rel=1 / 128)


@pytest.mark.parametrize("is_mesh", [False, True])
def test_the_certificate_says_how_much_a_solid_grows(is_mesh: bool, tmp_path: Path) -> None:
    block = mesh_slab(tmp_path, "a", 0, 0.5, "glass") if is_mesh else slab("a", 0, 0.5, "glass")
    made = lowered(scene(MATERIALS, "\n".join([PANELS["plane"], block]), lights=""))
    (entry,) = [each for each in made.certificate.entries if "reaches into" in each.target_law]
    assert str(entry.item) == "`a`" and 0 < entry.residual < 1e-2
    assert not [each for each in made.certificate.entries if "gap" in each.target_law]


SHARED_FACES = {
    "tank of glass": (["crown 0 0.9 0", "air 0.3 0.9 1", "heavy 0.3 0.6 2"], [(1, 2), (2, 1.5), (1.5, 1)], 1.0),
    "two liquids": (
        ["crown 0 0.9 0", "oil 0.3 0.9 1", "heavy 0.3 0.6 2"],
        [(1, 1.3), (1.3, 2), (2, 1.5), (1.5, 1)],
        1.0,
    ),
    "tank on a panel": (["crown -1 0.9 0", "air 0.3 0.9 1", "heavy 0.3 0.6 2"], [(1, 2), (2, 1.5)], 1.5),
}


@pytest.mark.parametrize("case", SHARED_FACES)
def test_of_two_faces_in_one_place_that_of_the_higher_priority_counts(case: str) -> None:
    """A bore as long as its tube, a liquid as wide as its vessel; each is seen as if the lower solid ended there.

    Plain text leaves a film of the lower solid, or loses a face; radiance inside glass counts n^2 less outside.
    """
    materials = MATERIALS + "air: {transmission: 1, ior: 1}\noil: {transmission: 1, ior: 1.3, fresnel: true}"
    bodies, faces, inside = SHARED_FACES[case]
    slabs = [slab(name, float(low), float(high), name, int(rank)) for name, low, high, rank in map(str.split, bodies)]
    panel = PANELS["plane"].replace("[0, 0, 0]", "[0, -1, 0]")
    expected = stack([face(*each) for each in faces]) / inside**2
    for order in ([panel, *slabs], [*reversed(slabs), panel]):
        made = rendered(scene(materials, "\n".join(order), lights="", camera=LOOKING_DOWN))
        assert made.image.radiance == pytest.approx(expected, rel=HALF_FLOAT), order


TUBE = "cylinder: {from: [0, 0, 0], to: [0, 1, 0], radius: 0.5}"
BLOCK = "box: {min: [-1, 0, -1], max: [1, 1, 1]}"
WEDGE = "prism: {profile: [[0, 0], [1, 0], [0, 1]], height: 1}"
BULB = "lens: {radius_front: 1, radius_back: 0, thickness: 0.4, diameter: 1}, rotate_deg: [90, 0, 0]"
BALL = "sphere: {center: [0, 0.5, 0], radius: 0.5}"


@pytest.mark.parametrize(
    ("lower", "higher", "is_flush"),
    [
        (TUBE, "cylinder: {from: [0, 0, 0], to: [0, 1, 0], radius: 0.3}", True),
        (TUBE, "cylinder: {from: [0, 0.9, 0], to: [0, 0.1, 0], radius: 0.5}", True),
        (TUBE, "cylinder: {from: [0, 0.1, 0], to: [0, 0.9, 0], radius: 0.3}", False),
        # A ball or a tube that touches the faces around it from inside has no face in common with them.
        (BLOCK, BALL, False),
        (BLOCK, "cylinder: {from: [0, 0.1, 0], to: [0, 0.9, 0], radius: 1}", False),
        (BLOCK, "cone: {from: [0, 0, 0], to: [0, 0.5, 0], radius_from: 0.4, radius_to: 0}", True),
        (BALL, BALL, True),
        (BALL, "sphere: {center: [0, 0.5, 0], radius: 0.4}", False),
        (WEDGE, "prism: {profile: [[0.1, 0.1], [0.9, 0.1], [0.1, 0.9]], height: 0.5}", True),
        (WEDGE, "prism: {profile: [[0.1, 0.1], [0.8, 0.1], [0.1, 0.8]], height: 0.5}", False),
        (BULB, "cylinder: {from: [0, -0.1, 0], to: [0, 0.2, 0], radius: 0.5}", True),
        ("plane: {point: [0, 1, 0], normal: [0, 1, 0]}", BLOCK, True),
    ],
)
def test_what_shares_a_face_with_what_it_takes_room_from(lower: str, higher: str, is_flush: bool) -> None:
    objects = f"""
    - {{name: higher, {higher}, material: flint, priority: 2}}
    - {{name: lower, {lower}, material: glass, priority: 1}}
    """
    found = orders(World.of(scene(MATERIALS, objects, lights="")), {1: 1})
    assert found == ({0: 2, 1: 1} if is_flush else {1: 1})


def test_the_longer_way_through_a_larger_solid_is_certified() -> None:
    """Ink that grows by 7.5e-5 m at both faces, three steps: its depth of 8 / m changes by 1.2e-3."""
    tumbler = load(Path(__file__).parents[3] / "scenes/calibration/tumbler.yaml")
    entries = lowered(tumbler).certificate.of(Phenomenon.ABSORPTION)
    (way,) = [entry for entry in entries if "the way through" in entry.source_law]
    assert str(way.item) == "`water`" and way.residual == pytest.approx(2 * 7.5e-5 * 8)
