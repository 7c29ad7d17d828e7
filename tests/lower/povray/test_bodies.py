"""Shapes, meshes, nested glass: where they are, and what light that crosses them keeps."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, LOOKING_DOWN, lowered, rendered, scene
from vitrail.geometry.placement import place
from vitrail.lower.povray import NotTranslatable
from vitrail.scene.load import load

pytestmark = pytest.mark.povray

SHAPES = {
    "sphere": "sphere: {center: [0.1, 0.2, 0], radius: 0.7}",
    "box": "box: {min: [-0.5, -0.3, -0.2], max: [0.4, 0.6, 0.3]}",
    "cylinder": "cylinder: {from: [-0.4, -0.5, 0], to: [0.5, 0.4, 0.3], radius: 0.25}",
    "cone": "cone: {from: [-0.4, -0.6, 0], to: [0.5, 0.4, 0.3], radius_from: 0.4, radius_to: 0.1}",
    "prism": "prism: {profile: [[-0.5, -0.4], [0.6, -0.5], [0.1, 0], [0.3, 0.7], [-0.6, 0.4]], height: 0.5}",
    "apex": "prism: {apex_deg: 50, side: 1.2, height: 0.5}",
    "biconvex": "lens: {radius_front: 0.8, radius_back: 1.1, thickness: 0.5, diameter: 1.1}",
    "biconcave": "lens: {radius_front: -0.9, radius_back: -0.7, thickness: 0.15, diameter: 1.1}",
    "meniscus": "lens: {radius_front: 0.8, radius_back: -1.2, thickness: 0.3, diameter: 1.2}",
    "torus": "torus: {center: [0.1, 0, -0.1], normal: [1, 2, -1], radius: 0.6, radius_tube: 0.25}",
    "thread": "torus: {center: [0, 0, 0], normal: [0, 1, 0], radius: 0.8, radius_tube: 0.1}",
    "lathe": "lathe: {profile: [[0, -0.6], [0.7, -0.6], [0.2, 0], [0.6, 0.5], [0.4, 0.5], [0, 0]]}",
    "tube": "lathe: {profile: [[0.4, 0.5], [0.7, 0.5], [0.6, -0.5], [0.4, -0.5]]}",
    "plano": "lens: {radius_front: 0, radius_back: 0.8, thickness: 0.4, diameter: 1.1}",
}


@pytest.mark.parametrize("name", SHAPES)
def test_a_solid_covers_what_its_definition_covers(name: str) -> None:
    """The silhouette of a glowing solid, turned and moved, against the sign of its depth along each line of sight."""
    turned = f"- {{name: s, {SHAPES[name]}, rotate_deg: [25, 40, -15], translate: [0.05, -0.1, 0], material: glow}}"
    camera = "camera: {kind: orthographic, position: [0, 0, 5], look_at: [0, 0, 0], height: 2.4}"
    loaded = scene("glow: {emission: 1}", turned, lights="", camera=camera, image="image: {width: 48, height: 48}")
    seen = rendered(loaded).image.radiance[..., 0] > 0.5
    step = (np.arange(48) + 0.5) / 20 - 1.2
    along = np.linspace(-1.5, 1.5, 601)
    points = np.stack(np.meshgrid(-step, step, along, indexing="ij"), axis=-1)[..., [1, 0, 2]].reshape(-1, 3)
    depth = place(loaded.scene.objects[0]).depth(points).reshape(48, 48, -1).max(axis=2)
    # Lines that graze the surface within the steps along them may fall on either side.
    clear = abs(depth) > 0.006
    assert clear.mean() > 0.9 and np.array_equal(seen[clear], depth[clear] > 0)


def through(objects: str, materials: str) -> float:
    """Radiance of a panel of radiance 1 as seen straight down through some bodies."""
    panel = "- {name: panel, plane: {point: [0, -1, 0], normal: [0, 1, 0]}, material: panel}\n"
    seen = rendered(scene("panel: {emission: 1}\n" + materials, panel + objects, lights="", camera=LOOKING_DOWN))
    assert seen.image.radiance.std() < 1e-6
    return float(seen.mean[0])


def slab(name: str, low: float, high: float, material: str, priority: int = 0, half: int = 2) -> str:
    return (
        f"- {{name: {name}, material: {material}, priority: {priority},"
        f" box: {{min: [-{half}, {low}, -{half}], max: [{half}, {high}, {half}]}}}}"
    )


def stack(reflectances: list[float]) -> float:
    """Transmittance of lossless faces one behind the other, all bounces, without interference."""
    transmitted, mirrored = 1.0, 0.0
    for r in reflectances:
        both = 1 - mirrored * r
        transmitted, mirrored = transmitted * (1 - r) / both, mirrored + transmitted**2 * r / both
    return transmitted


def face(n1: float, n2: float) -> float:
    return ((n1 - n2) / (n1 + n2)) ** 2


GLASSES = "crown: {transmission: 1, ior: 1.5, fresnel: true}\nflint: {transmission: 1, ior: 2, fresnel: true}"


def test_overlapping_glass_has_one_face_where_the_higher_priority_begins() -> None:
    """Crown from 0 to 0.5 and flint from 0.3 to 0.8: air, crown, flint, air."""
    both = slab("a", 0, 0.5, "crown", 0) + "\n" + slab("b", 0.3, 0.8, "flint", 1)
    expected = stack([face(1, 1.5), face(1.5, 2), face(2, 1)])
    assert through(both, GLASSES) == pytest.approx(expected, rel=HALF_FLOAT)


def test_glass_inside_glass_has_the_faces_of_the_inner_one() -> None:
    both = slab("a", 0, 0.8, "crown", 0) + "\n" + slab("b", 0.3, 0.5, "flint", 1, half=1)
    expected = stack([face(1, 1.5), face(1.5, 2), face(2, 1.5), face(1.5, 1)])
    assert through(both, GLASSES) == pytest.approx(expected, rel=HALF_FLOAT)


def test_air_inside_glass_is_taken_out_of_it() -> None:
    """The faces of the hollow belong to the air, which mirrors and tints nothing."""
    materials = "glass: {transmission: 0.5, ior: 1.5, absorption_per_m: 2}\nair: {transmission: 1, ior: 1}"
    both = slab("a", 0, 0.8, "glass", 0) + "\n" + slab("b", 0.3, 0.5, "air", 1, half=1)
    assert through(both, materials) == pytest.approx(0.25 * math.exp(-2 * 0.6), rel=HALF_FLOAT)


def test_air_in_glass_that_overlaps_other_glass_keeps_its_own_faces() -> None:
    """The upper glass has a look of its own from inside, which the faces of the air in it must not take over."""
    materials = "glass: {transmission: 1, ior: 1.5, fresnel: true}\nair: {transmission: 1, ior: 1}"
    bodies = [slab("a", 0, 0.4, "glass", 0), slab("b", 0.3, 0.8, "glass", 1), slab("c", 0.5, 0.6, "air", 2, half=1)]
    expected = stack([face(1, 1.5), face(1.5, 1)])
    assert through("\n".join(bodies), materials) == pytest.approx(expected, rel=HALF_FLOAT)


def test_glass_in_a_bubble_in_glass_has_all_its_faces() -> None:
    """Crown with air inside, whose faces do not mirror, and flint in the air: four faces that mirror."""
    bodies = [slab("a", 0, 0.9, "crown"), slab("b", 0.1, 0.8, "air", 1, 1), slab("c", 0.3, 0.6, "flint", 2, 1)]
    expected = stack([face(1, 1.5), face(1, 2), face(2, 1), face(1.5, 1)])
    materials = GLASSES + "\nair: {transmission: 1, ior: 1}"
    # 0.1 %: half floats, and of the many ways between four mirrors those that weigh less than 1e-4 end.
    assert through("\n".join(bodies), materials) == pytest.approx(expected, rel=1e-3)


def test_absorbing_glass_inside_clear_glass_absorbs_on_its_own_way_only() -> None:
    materials = "dark: {transmission: 1, ior: 1.5, absorption_per_m: 3}\nclear: {transmission: 1, ior: 1.7}"
    both = slab("a", 0, 0.8, "clear", 0) + "\n" + slab("b", 0.3, 0.5, "dark", 1, half=1)
    assert through(both, materials) == pytest.approx(math.exp(-3 * 0.2), rel=HALF_FLOAT + 5e-4)


def test_absorbing_glass_around_clear_glass_absorbs_on_its_own_way_only() -> None:
    """POV-Ray's own fade would forget the way up to the inner body."""
    materials = "dark: {transmission: 1, ior: 1.5, absorption_per_m: 3}\nclear: {transmission: 1, ior: 1.7}"
    both = slab("a", 0, 0.8, "dark", 0) + "\n" + slab("b", 0.3, 0.5, "clear", 1, half=1)
    # A hair of 2.5e-3 units is missing from the clear body's room: 1e-4 of the light here.
    assert through(both, materials) == pytest.approx(math.exp(-3 * 0.6), rel=HALF_FLOAT + 5e-4)


DARK = "dark: {transmission: 1, ior: 3, fresnel: true, absorption_per_m: 1}\n"


def dark_stack(way: float) -> float:
    """Transmittance of a pane of DARK, all bounces, each way between the faces absorbing."""
    mirrored, kept = face(1, 3), math.exp(-way)
    return (1 - mirrored) ** 2 * kept / (1 - (mirrored * kept) ** 2)


def test_glass_that_mirrors_inside_absorbs_on_every_way_between_its_faces() -> None:
    """POV-Ray's own fade dims what leaves through a face, and not what the face mirrors back: 5 % too much here."""
    assert through(slab("a", 0, 0.7, "dark"), DARK) == pytest.approx(dark_stack(0.7), rel=HALF_FLOAT + 5e-4)


def test_photons_are_absorbed_on_every_way_between_the_faces_too() -> None:
    objects = "- {name: floor, plane: {point: [0, -1, 0], normal: [0, 1, 0]}, material: card}\n"
    below = "camera: {kind: orthographic, position: [0, -0.5, 0], look_at: [0, -1, 0], up: [0, 0, -1], height: 0.5}"
    sun = "- {name: sun, directional: {direction: [0, -1, 0], irradiance: 3.141592653589793}}"
    made = scene(DARK + "card: {diffuse: 0.5}", objects + slab("a", 0, 0.7, "dark"), sun, camera=below)
    # Photons are counted in 8 bits: up to one step of 1/128 is lost.
    assert rendered(made, photons=200_000).mean[0] == pytest.approx(0.5 * dark_stack(0.7), rel=1 / 128)


def test_a_body_in_absorbing_glass_is_seen_through_it() -> None:
    cast = "- {name: cast, rectangle: {center: [0, 0.3, 0], u: [1, 0, 0], v: [0, 0, -1]}, material: panel}\n"
    seen = through(slab("a", 0, 0.8, "tint") + "\n" + cast, "tint: {transmission: 1, ior: 1.5, absorption_per_m: 1}")
    assert seen == pytest.approx(math.exp(-0.5) / 1.5**2, rel=HALF_FLOAT + 5e-4)


def test_a_camera_inside_glass_looks_out_through_one_face() -> None:
    """[O 1.1 row 10] Refraction gathers the light of the panel into a cone smaller by n^2."""
    inside = slab("a", -0.5, 2, "tint")
    assert through(inside, "tint: {transmission: 0.5, ior: 1.5}") == pytest.approx(0.5 * 1.5**2, rel=HALF_FLOAT)


def write_cube(folder: Path, name: str) -> Path:
    """A cube of edge 1 as triangles, outward, in the format its name says, and a scene that looks through it."""
    corners = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
    if name.endswith(".obj"):
        rows = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
        (folder / name).write_text("\n".join(rows) + "\n")
    else:
        kind = "binary_little_endian" if "binary" in name else "ascii"
        head = f"ply\nformat {kind} 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
        head += "element face 12\nproperty list uchar int vertex_indices\nend_header\n"
        if kind == "ascii":
            rows = [f"{x} {y} {z}" for x, y, z in corners] + [f"3 {a} {b} {c}" for a, b, c in faces]
            (folder / name).write_text(head + "\n".join(rows) + "\n")
        else:
            packed = np.array(corners, "<f4").tobytes()
            for triangle in faces:
                packed += b"\x03" + np.array(triangle, "<i4").tobytes()
            (folder / name).write_bytes(head.encode() + packed)
    text = f"""
vitrail: 1
camera: {{kind: orthographic, position: [0, 2, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.6}}
image: {{width: 16, height: 16}}
materials: {{panel: {{emission: 1}}, glass: {{transmission: 0.5, ior: 1.5, absorption_per_m: 0.4}}}}
objects:
  - {{name: panel, plane: {{point: [0, -2, 0], normal: [0, 1, 0]}}, material: panel}}
  - {{name: cube, mesh: {{file: {name}, smooth: false}}, translate: [0.1, 0, 0.05], material: glass}}
lights: []
"""
    path = folder / "scene.yaml"
    path.write_text(text)
    return path


@pytest.mark.parametrize("name", ["cube.ply", "cube_binary.ply", "cube.obj"])
def test_a_mesh_is_a_solid_of_glass(tmp_path: Path, name: str) -> None:
    seen = rendered(load(write_cube(tmp_path, name)))
    assert seen.image.radiance == pytest.approx(0.25 * math.exp(-0.4), rel=HALF_FLOAT)


def test_a_damaged_mesh_is_refused_with_its_line(tmp_path: Path) -> None:
    path = write_cube(tmp_path, "cube.ply")
    (tmp_path / "cube.ply").write_text("ply\nformat ascii 1.0\nelement vertex 8\nend_header\n1 2\n")
    with pytest.raises(NotTranslatable, match=r"scene.yaml:8:.*mesh"):
        lowered(load(path))


def test_a_smooth_mesh_of_a_ball_projects_the_balls_light(tmp_path: Path) -> None:
    """Photons through a smooth mesh: the caustic of a fine ball of triangles against the analytic ball, within 3 %."""
    rings, around = 48, 96
    vertices = [(0, 1, 0)]
    for ring in range(1, rings):
        polar = math.pi * ring / rings
        for k in range(around):
            turn = 2 * math.pi * k / around
            vertices.append((math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn)))
    vertices.append((0, -1, 0))
    last = len(vertices) - 1
    faces = []
    for k in range(around):
        following = (k + 1) % around
        faces.append((0, 1 + following, 1 + k))
        faces.append((last, last - around + k, last - around + following))
        for ring in range(rings - 2):
            a, b = 1 + ring * around + k, 1 + ring * around + following
            faces += [(a, b, b + around), (a, b + around, a + around)]
    rows = [f"v {x} {y} {z}" for x, y, z in vertices] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    (tmp_path / "ball.obj").write_text("\n".join(rows) + "\n")
    text = (Path(__file__).parents[3] / "scenes/calibration/ball_lens.yaml").read_text()
    (tmp_path / "mesh.yaml").write_text(
        text.replace("sphere: {center: [0, 2, 0], radius: 1}", "mesh: {file: ball.obj}, translate: [0, 2, 0]")
    )
    (tmp_path / "ball.yaml").write_text(text)
    settings = {"photons": 300_000, "gather_radius_m": 0.06}
    mesh, ball = (rendered(load(tmp_path / name), **settings) for name in ("mesh.yaml", "ball.yaml"))
    size = ball.image.radiance.shape[0]
    y, x = (np.mgrid[0:size, 0:size] + 0.5 - size / 2) * (2.6 / size)
    radius = np.hypot(x, y)
    for low, high in ((0.1, 0.3), (0.3, 0.5), (0.5, 0.8)):
        ring = (radius >= low) & (radius < high)
        assert mesh.image.radiance[ring].mean() == pytest.approx(ball.image.radiance[ring].mean(), rel=0.03)
