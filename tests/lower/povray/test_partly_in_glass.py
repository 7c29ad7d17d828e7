"""An opaque body that stands in glass with a part of it: there, and only there, its radiance is seen divided by n^2."""

from __future__ import annotations

import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, lowered, rendered, scene
from vitrail.scene.load import Loaded

pytestmark = pytest.mark.povray

SHAPES = {
    "rectangle": "rectangle: {center: [0, 0, 0], u: [1, 0, 0], v: [0, 0, -1]}",
    "disc": "disc: {center: [0, 0, 0], normal: [0, 1, 0], radius: 1}",
    "box": "box: {min: [-1, -0.3, -1], max: [1, 0, 1]}",
    "plane": "plane: {point: [0, 0, 0], normal: [0, 1, 0]}",
    "sphere": "sphere: {center: [0, -2, 0], radius: 2}",
}
"""What glows with radiance 1 at the middle of the picture."""


def half_sunk(shape: str, block: str = "[-2, -1, -2], max: [0, 0.5, 2]") -> Loaded:
    """A glowing body, and a block of glass around what lies to its left; seen from above, 0.2 wide."""
    materials = "glow: {emission: 1}\nglass: {transmission: 1, ior: 1.5, fresnel: true}"
    objects = f"""
    - {{name: body, {SHAPES[shape]}, material: glow}}
    - {{name: block, box: {{min: {block}}}, material: glass}}
    """
    camera = "camera: {kind: orthographic, position: [0, 1, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.2}"
    return scene(materials, objects, lights="", camera=camera, image="image: {width: 8, height: 8}")


@pytest.mark.parametrize("shape", SHAPES)
def test_the_part_in_glass_is_darker_by_the_square_of_the_index(shape: str) -> None:
    """Straight up through one face: (1 - R) / n^2 with R = 0.04; beside the glass 1. 2e-3: a ball has sides."""
    radiance = rendered(half_sunk(shape)).image.radiance[..., 0]
    assert radiance[:, :3] == pytest.approx(0.96 / 1.5**2, rel=2e-3)
    assert radiance[:, 5:] == pytest.approx(1, rel=HALF_FLOAT)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_body_beside_the_glass_is_written_plainly(shape: str) -> None:
    """Nothing is asked place by place where no part is inside; a block that touches nothing is beside it."""
    text = lowered(half_sunk(shape, "[-2, 0.1, -2], max: [0, 0.5, 2]")).runs[0].sdl
    assert "object {" not in text
    assert "object {" in lowered(half_sunk(shape)).runs[0].sdl
