"""Axes of light: photons far from the origin, strong photons, bright and dim lamps."""

from __future__ import annotations

import math

import numpy as np

from vitrail.study.extremes.axis import Axis, Tolerance
from vitrail.study.extremes.sdl_text import CLEAR, header, orthographic
from vitrail.study.extremes.search import walk

SPACING = 1 / 16
GATHER_RADIUS = 0.5


def _projected_scene(irradiance: float, offset: float = 0.0) -> str:
    """A pane that only passes light on (ior 1), over a white floor: the floor shows E / pi, all of it by photons."""
    x = offset
    return f"""vitrail: 1
title: A floor lit through a pane of ior 1
camera: {{kind: orthographic, position: [{x!r}, 2, 0], look_at: [{x!r}, 0, 0], up: [0, 0, 1], height: 0.5}}
image: {{width: 4, height: 4}}
materials:
  floor: {{diffuse: 1}}
  pane: {{transmission: 1, ior: 1}}
objects:
  - {{name: floor, plane: {{point: [{x!r}, 0, 0], normal: [0, 1, 0]}}, material: floor}}
  - {{name: pane, box: {{min: [{x - 4!r}, 3, -4], max: [{x + 4!r}, 3.5, 4]}}, material: pane}}
lights:
  - {{name: sun, directional: {{direction: [0, -1, 0], irradiance: {irradiance!r}}}}}
"""


def _projected_sdl(irradiance: float, offset: float = 0.0) -> str:
    x = offset
    photons = f"spacing {SPACING!r} gather 1,100000 radius {GATHER_RADIUS!r} autostop 1"
    target = "photons { target refraction on reflection off collect off }"
    return (
        header(photons)
        + orthographic((x, 2, 0), (0, -1, 0), (1, 0, 0), (0, 0, 1), 0.5)
        + f"light_source {{ <{x!r},100,0> rgb {irradiance / math.pi!r} parallel point_at <{x!r},0,0> }}\n"
        + "plane { y,0 pigment { rgb 1 } finish { diffuse 1 } }\n"
        + f"box {{ <{x - 4!r},3,-4>,<{x + 4!r},3.5,4> {CLEAR} interior {{ ior 1 }} {target} }}\n"
    )


PHOTON_NOISE = "about 200 photons in the kernel: 7 % of noise a pixel at most, the loss looked for is total"


def _worst_pixel(image: np.ndarray, value: float) -> float:
    """The pixel farthest from the mean of the image, so that a collapse of photon positions shows."""
    channel = image[..., 0]
    return float(channel.flat[int(np.argmax(np.abs(channel - math.pi**-1)))])


OFFSET = Axis(
    name="offset",
    quantity="distance of a caustic from the origin",
    unit="m",
    invariant="moving a scene changes no picture: a floor behind clear glass shows E / pi",
    values=tuple(walk(1.0, 10.0, 8)),
    scene=lambda offset: _projected_scene(1.0, offset),
    sdl=lambda offset: _projected_sdl(1.0, offset),
    expected=lambda offset: 1 / math.pi,
    tolerance={"tracer": Tolerance(0.1, PHOTON_NOISE), "povray": Tolerance(0.1, PHOTON_NOISE)},
    read=_worst_pixel,
    photons=20_000,
    limit={"povray": "photon positions are single precision: 1/16 m is lost at about 1e6 m"},
)


PHOTON_FLUX = Axis(
    name="photon_flux",
    quantity="flux of one photon (light colour times spacing squared)",
    unit="W",
    invariant="twice the light is twice the picture",
    values=tuple(walk(0.25, 4.0, 12)),
    scene=lambda flux: _projected_scene(math.pi * flux / SPACING**2),
    sdl=lambda flux: _projected_sdl(math.pi * flux / SPACING**2),
    expected=lambda flux: flux / SPACING**2,
    tolerance={"tracer": Tolerance(0.1, PHOTON_NOISE), "povray": Tolerance(0.1, PHOTON_NOISE)},
    photons=20_000,
    limit={"povray": "photon colours are four bytes with a shared exponent that ends at 32"},
)


def _card_scene(irradiance: float) -> str:
    return f"""vitrail: 1
title: A grey card under a directional light of {irradiance!r} W/m2
camera: {{kind: orthographic, position: [0, 2, 0], look_at: [0, 0, 0], up: [0, 0, 1], height: 0.5}}
image: {{width: 4, height: 4}}
materials:
  card: {{diffuse: 1}}
objects:
  - {{name: card, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: card}}
lights:
  - {{name: sun, directional: {{direction: [0, -1, 0], irradiance: {irradiance!r}}}}}
"""


def _card_sdl(irradiance: float) -> str:
    return (
        header()
        + orthographic((0, 2, 0), (0, -1, 0), (1, 0, 0), (0, 0, 1), 0.5)
        + f"light_source {{ <0,100,0> rgb {irradiance / math.pi!r} parallel point_at 0 }}\n"
        + "plane { y,0 pigment { rgb 1 } finish { diffuse 1 } }\n"
    )


def _radiance_axis(name: str, quantity: str, factor: float) -> Axis:
    return Axis(
        name=name,
        quantity=quantity,
        unit="W/m2",
        invariant="a white card shows E / pi",
        values=tuple(walk(1.0, factor, 11)),
        scene=_card_scene,
        sdl=_card_sdl,
        expected=lambda irradiance: irradiance / math.pi,
        tolerance={
            "tracer": Tolerance(1e-6, "images are single precision: 6e-8 of rounding a product"),
            "povray": Tolerance(1e-3, "half floats round to 5e-4"),
        },
        limit={
            "tracer": "images are single precision: 3.4e38 is the largest, 1.2e-38 the smallest full number",
            "povray": "half floats end at 65504, and lose digits below 6e-5",
        },
    )


BRIGHT = _radiance_axis("bright", "irradiance, upwards", 1e4)
DIM = _radiance_axis("dim", "irradiance, downwards", 1e-4)

LIGHT_AXES = (OFFSET, PHOTON_FLUX, BRIGHT, DIM)
