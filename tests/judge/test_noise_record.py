"""Which light can owe its noise to rays drawn at random: what rough glass shows, and what wide lamps light."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.metrics.synthetic import noisy, patch_of
from vitrail.images.patch import PatchSamples
from vitrail.judge.noise_record import noise_records
from vitrail.scene.load import load_text
from vitrail.scene.model import Scene

pytestmark = pytest.mark.fast

SCENE = """
vitrail: 1
camera: {position: [0, 1, 4], look_at: [0, 0, 0], fov_deg: 30}
image: {width: 8, height: 8}
materials:
  white: {diffuse: 0.7}
  glass: {transmission: 1, ior: 1.5, roughness: ROUGHNESS}
objects:
  - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: white}
  - {name: ball, sphere: {center: [0, 0.5, 0], radius: 0.5}, material: glass}
lights:
  - {name: sun, directional: {direction: [0, -1, 0], irradiance: 3, angular_diameter_deg: DIAMETER}}
"""


def scene(roughness: float = 0.0, diameter: float = 0.0) -> Scene:
    return load_text(SCENE.replace("ROUGHNESS", str(roughness)).replace("DIAMETER", str(diameter))).scene


def card(direct: str, *, photons: float = 0.01) -> PatchSamples:
    """A patch that glass shows or that lies bare, dark to the left, in noise that follows the square of its light."""
    light = patch_of(lambda u, v: 1.2 + u + 0 * v)
    seen = noisy(light, 0.02 * light.values[..., :1], 3)
    return replace(seen, layers={direct: light.values, "caustic": photons * np.ones_like(light.values)})


def test_rough_glass_draws_rays_where_it_is_looked_at() -> None:
    (through,) = noise_records({"tracer": card("refraction")}, scene(roughness=0.3))
    assert through.rays > 0.9 * (through.photons + through.edges)
    # The other engine has no layers; what its light differs by from those of the tracer is noise.
    other = replace(card("diffusion"), layers={})
    for bare in noise_records({"tracer": card("diffusion"), "povray": other}, scene(roughness=0.3)):
        assert bare.rays == 0 and bare.photons > 0


def test_a_wide_lamp_draws_rays_everywhere_and_a_point_none() -> None:
    (wide,) = noise_records({"tracer": card("diffusion")}, scene(diameter=0.5))
    assert wide.rays > 0.9 * (wide.photons + wide.edges)
    (narrow,) = noise_records({"tracer": card("refraction")}, scene())
    assert narrow.rays == 0


def test_discs_are_counted_in_cells_of_the_patch() -> None:
    """A gather radius of two cells: a disc of 4 pi cells."""
    samples = card("diffusion")
    radius_m = 2 * samples.cell_u_m
    (fine,), (coarse,) = (noise_records({"tracer": samples}, scene(), radius) for radius in (0.0, radius_m))
    assert coarse.photons == pytest.approx(4 * np.pi * fine.photons)
