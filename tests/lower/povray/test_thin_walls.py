"""A wall of glass that another body leaves: both its faces are seen, or the glass is refused with its line."""

from __future__ import annotations

import pytest

from tests.lower.povray.real_povray import lowered, rendered, scene
from vitrail.lower.povray import NotTranslatable
from vitrail.scene.load import Loaded

pytestmark = pytest.mark.povray

BODIES = {
    "bubble": ("sphere: {center: [0, 0, 0], radius: 1}", "sphere: {center: [0, 0, 0], radius: %r}"),
    "tube": (
        "cylinder: {from: [0, 0, -1], to: [0, 0, 1], radius: 1}",
        "cylinder: {from: [0, 0, -2], to: [0, 0, 2], radius: %r}",
    ),
    "tank": ("box: {min: [-1, -1, -1], max: [1, 1, 1]}", "box: {min: [-2, -%r, -2], max: [2, 2, 2]}"),
}
"""Glass, and the air in it; seen from above along the shortest way through the walls."""
WALLS = {"bubble": 2, "tube": 2, "tank": 1}


def hollow(body: str, wall: float) -> Loaded:
    """A hollow body of glass before a glowing floor."""
    solid, air = BODIES[body]
    objects = f"""
    - {{name: floor, plane: {{point: [0, -2, 0], normal: [0, 1, 0]}}, material: glow}}
    - {{name: glass, {solid}, material: glass}}
    - {{name: air, {air % (1 - wall)}, material: air, priority: 1}}
    """
    materials = """
    glow: {emission: 1}
    glass: {transmission: 1, ior: 1.5, fresnel: true}
    air: {transmission: 1, ior: 1, fresnel: true}
    """
    camera = "camera: {kind: orthographic, position: [0, 5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.1}"
    return scene(materials, objects, lights="", camera=camera, image="image: {width: 4, height: 4}")


@pytest.mark.parametrize(
    ("body", "wall"),
    [("bubble", 1e-3), ("bubble", 6e-6), ("tube", 1e-3), ("tube", 1e-5), ("tank", 1e-3), ("tank", 1e-5)],
)
def test_a_thin_wall_keeps_both_faces(body: str, wall: float) -> None:
    """A wall passes T = (1 - R) / (1 + R), R = 0.04; what two walls throw back and forth adds a share r^2, r = 1 - T.

    1e-3: half floats, and the slant of what is curved. With one face of each lost 0.960 or 0.922 would be seen.
    """
    once = 0.96 / 1.04
    seen = once if WALLS[body] == 1 else once**2 / (1 - (1 - once) ** 2)
    assert rendered(hollow(body, wall)).mean[0] == pytest.approx(seen, rel=1e-3)


@pytest.mark.parametrize("body", BODIES)
def test_a_wall_beyond_all_scales_is_refused_with_its_line(body: str) -> None:
    with pytest.raises(NotTranslatable, match=r"scene.yaml:10:.*a feature of 1e-07 m"):
        lowered(hollow(body, 1e-7))
