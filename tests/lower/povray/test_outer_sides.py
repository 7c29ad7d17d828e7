"""Every face of a solid shows POV-Ray its outer look from outside: its normal points out of the body, all around."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, rendered, scene
from tests.lower.povray.test_bodies import SHAPES
from vitrail.scene.load import Loaded, load

pytestmark = pytest.mark.povray

TURNS = ("[10, 20, 0]", "[100, 10, 10]", "[190, 20, 0]", "[-80, 10, 10]", "[10, 110, 20]", "[10, -70, 20]")
"""Each of the six ends of a body's axes towards the camera once, a little aslant."""
AMBIENT = "transport: {indirect: {ambient: 3.141592653589793}}"


@pytest.mark.parametrize("shape", SHAPES)
def test_every_face_shows_its_outer_look(shape: str) -> None:
    """A body that lets 0.001 through shows its diffuse share of 0.999 in ambient light; from inside 1 / n^2 of that."""
    places = [(3 * column - 3, 3 * row - 1.5) for column in range(3) for row in range(2)]
    bodies = [
        f"- {{name: s{index}, {SHAPES[shape]}, rotate_deg: {turn}, translate: [{x}, {y}, 0], material: chalk}}"
        for index, ((x, y), turn) in enumerate(zip(places, TURNS, strict=True))
    ]
    camera = "camera: {kind: orthographic, position: [0, 0, 9], look_at: [0, 0, 0], height: 6}"
    chalk = "chalk: {diffuse: 0.999, transmission: 0.001, ior: 2}"
    loaded = scene(chalk, "\n".join(bodies), "", camera, "image: {width: 108, height: 72}", AMBIENT)
    shown = rendered(loaded).image.radiance[..., 0]
    inner = inside_outlines(shown > 0)
    assert inner.sum() > 100
    assert shown[inner] == pytest.approx(0.999, abs=2e-3)


OCTAHEDRON = """
v 1 0 0
v -1 0 0
v 0 1 0
v 0 -1 0
v 0 0 1
v 0 0 -1
f 1 3 5
f 3 2 5
f 2 4 5
f 4 1 5
f 3 1 6
f 2 3 6
f 4 2 6
f 1 4 6
"""
"""Outward triangles, counter-clockwise from outside."""


def with_octahedron(folder: Path, text: str) -> Loaded:
    """A scene in a folder beside ``body.obj``."""
    (folder / "body.obj").write_text(OCTAHEDRON)
    (folder / "scene.yaml").write_text("vitrail: 1\n" + text)
    return load(folder / "scene.yaml")


@pytest.mark.parametrize("eye", ["[4, 5, 6]", "[-4, -5, -6]"])
def test_every_face_of_a_mesh_shows_its_outer_look(tmp_path: Path, eye: str) -> None:
    """Flat triangles: what lets 0.001 through shows 0.999 of the ambient light; from inside 1 / n^2 of that."""
    text = f"""
camera: {{kind: orthographic, position: {eye}, look_at: [0, 0, 0], height: 2}}
image: {{width: 32, height: 32}}
materials: {{chalk: {{diffuse: 0.999, transmission: 0.001, ior: 2}}}}
objects: [{{name: body, mesh: {{file: body.obj, smooth: false}}, material: chalk}}]
lights: []
{AMBIENT}
"""
    shown = rendered(with_octahedron(tmp_path, text)).image.radiance[..., 0]
    inner = inside_outlines(shown > 0)
    assert inner.sum() > 100
    assert shown[inner] == pytest.approx(0.999, abs=2e-3)


def test_a_mesh_inside_glass_loses_no_light(tmp_path: Path) -> None:
    """Lossless glass in a white furnace is invisible: a gem in a ball, with total reflection in the gem."""
    text = """
camera: {position: [1.5, 2, 5], look_at: [0, 0, 0], fov_deg: 30}
image: {width: 24, height: 24}
materials: {ball: {transmission: 1, ior: 1.4, fresnel: true}, gem: {transmission: 1, ior: 2.2, fresnel: true}}
objects:
  - {name: ball, sphere: {center: [0, 0, 0], radius: 1.6}, material: ball}
  - {name: gem, mesh: {file: body.obj, smooth: false}, material: gem, priority: 1}
lights: [{name: sky, environment: {radiance: 1}}]
transport: {max_reflections: 30, max_transmissions: 64}
"""
    shown = rendered(with_octahedron(tmp_path, text)).image.radiance
    # Branches below a share of 1e-4 are cut; a few rays of the rim go round and round.
    assert shown.mean() == pytest.approx(1, rel=1e-3)
    assert shown.min() > 0.98


@pytest.mark.parametrize(
    "body", ["sphere: {center: [0, 1.2, 0], radius: 1}", "mesh: {file: body.obj}, translate: [0, 1.2, 0]"]
)
def test_a_camera_on_a_face_looks_away_from_the_glass(tmp_path: Path, body: str) -> None:
    """Under the lowest point of a body, looking down: what glows is seen as it is, and not n^2 too bright."""
    text = f"""
camera: {{position: [0, 0.2, 0], look_at: [0, 0, 0], up: [0, 0, 1], fov_deg: 40}}
image: {{width: 8, height: 8}}
materials: {{panel: {{emission: 1}}, glass: {{transmission: 1, ior: 1.5, fresnel: true}}}}
objects:
  - {{name: panel, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: panel}}
  - {{name: body, {body}, material: glass}}
lights: []
"""
    assert rendered(with_octahedron(tmp_path, text)).image.radiance == pytest.approx(1, rel=HALF_FLOAT)


def inside_outlines(covered: np.ndarray) -> np.ndarray:
    """The pixels of bodies whose neighbours are all of bodies."""
    inner = covered[1:-1, 1:-1].copy()
    for row in range(3):
        for column in range(3):
            inner &= covered[row : row + inner.shape[0], column : column + inner.shape[1]]
    return np.pad(inner, 1)


@pytest.mark.parametrize("depth", [1, -1])
@pytest.mark.parametrize(
    ("dispersion", "indices"),
    [("", [[1.6], [1.6], [1.6]]), (", dispersion: 0.1", [[1.6, 1.7], [1.7, 1.8], [1.9]])],
)
def test_a_prism_seen_through_its_ends_keeps_what_each_face_sends(
    dispersion: str, indices: list[list[float]], depth: int
) -> None:
    """Along the sweep: d E / pi (1 + t / n^2), one face from outside and one from inside.

    A channel is the mean of its bands, each with the index that it has in them.
    """
    glass = f"glass: {{diffuse: 0.25, transmission: 0.75, ior: 1.6{dispersion}}}"
    camera = f"camera: {{kind: orthographic, position: [0, 0, {3 * depth}], look_at: [0, 0, 0], height: 0.2}}"
    prism = "- {name: prism, prism: {apex_deg: 60, side: 2, height: 1}, material: glass}"
    seen = rendered(scene(glass, prism, "", camera, "image: {width: 8, height: 8}", AMBIENT))
    expected = [0.25 * (1 + 0.75 * np.mean([n**-2 for n in bands])) for bands in indices]
    assert seen.mean == pytest.approx(expected, rel=HALF_FLOAT)
    assert seen.image.radiance.std(axis=(0, 1)).max() < 1e-6
