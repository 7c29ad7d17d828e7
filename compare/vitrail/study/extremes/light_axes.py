"""Axes of light: photons far from the origin, strong photons, bright and dim lamps."""

from __future__ import annotations

import math

import numpy as np

from vitrail.base.record import JsonObject
from vitrail.study.extremes.axis import POVRAY, TRACER, Axis, Tolerance
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
    invariant="moving a scene changes no picture: a floor behind clear glass shows what it shows at the origin",
    values=tuple(walk(1.0, 10.0, 8)),
    scene=lambda offset: _projected_scene(1.0, offset),
    sdl=lambda offset: _projected_sdl(1.0, offset),
    expected=lambda offset: float("nan"),  # the reading at the first value
    tolerance={
        TRACER: Tolerance(1e-5, "the same photons; a few may cross the edge of a kernel by rounding"),
        POVRAY: Tolerance(0.1, PHOTON_NOISE),
    },
    read=_worst_pixel,
    photons=20_000,
    limit={POVRAY: "photon positions are single precision: 1/16 m is lost at about 1e6 m"},
)


PHOTON_FLUX = Axis(
    name="photon_flux",
    quantity="flux of one photon (light colour times spacing squared)",
    unit="W",
    invariant="twice the light is twice the picture",
    values=tuple(walk(0.25, 4.0, 12)),
    scene=lambda flux: _projected_scene(math.pi * flux / SPACING**2),
    sdl=lambda flux: _projected_sdl(math.pi * flux / SPACING**2),
    expected=lambda flux: float("nan"),  # the reading at the first value
    tolerance={
        TRACER: Tolerance(0.0, "powers of two are exact, in the photons and in the image"),
        POVRAY: Tolerance(0.02, "a photon's colour has eight bits, the image eleven"),
    },
    read=lambda image, flux: float(np.mean(image, dtype=float)) / flux,
    is_binary=True,
    photons=20_000,
    limit={POVRAY: "photon colours are four bytes with a shared exponent that ends at 32"},
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
        invariant="twice the light is twice the picture: a white card shows E / pi",
        values=tuple(walk(1.0, factor, 11)),
        scene=_card_scene,
        sdl=_card_sdl,
        expected=lambda irradiance: float("nan"),  # the reading at the first value
        tolerance={
            TRACER: Tolerance(0.0, "powers of two are exact, in the image too"),
            POVRAY: Tolerance(1e-3, "half floats round to 5e-4"),
        },
        read=lambda image, irradiance: float(np.mean(image, dtype=float)) / irradiance,
        is_binary=True,
        limit={
            TRACER: "images are single precision: 3.4e38 is the largest, 1.2e-38 the smallest full number",
            POVRAY: "half floats end at 65504, and lose digits below 6e-5",
        },
    )


BRIGHT = _radiance_axis("bright", "irradiance, upwards", 2.0**13)
DIM = _radiance_axis("dim", "irradiance, downwards", 2.0**-13)


def _deep_scene(panes: float) -> str:
    count = int(panes)
    boxes = "\n".join(
        f"  - {{name: pane{i}, material: pane,"
        f" box: {{min: [-4, {3 + 0.25 * i!r}, -4], max: [4, {3.125 + 0.25 * i!r}, 4]}}}}"
        for i in range(count)
    )
    return f"""vitrail: 1
title: A floor lit through {count} panes of ior 1
camera: {{kind: orthographic, position: [0, 2, 0], look_at: [0, 0, 0], up: [0, 0, 1], height: 0.5}}
image: {{width: 4, height: 4}}
materials:
  floor: {{diffuse: 1}}
  pane: {{transmission: 1, ior: 1}}
objects:
  - {{name: floor, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: floor}}
{boxes}
lights:
  - {{name: sun, directional: {{direction: [0, -1, 0], irradiance: 1}}}}
transport: {{max_transmissions: {min(1000, 2 * count)}}}
"""


def _deep_sdl(panes: float) -> str:
    count = int(panes)
    photons = f"spacing {SPACING!r} gather 1,100000 radius {GATHER_RADIUS!r} autostop 1"
    target = "photons { target refraction on reflection off collect off }"
    boxes = "".join(
        f"box {{ <-4,{3 + 0.25 * i!r},-4>,<4,{3.125 + 0.25 * i!r},4> {CLEAR} interior {{ ior 1 }}"
        f" {target if i == count - 1 else 'photons { refraction on reflection off collect off }'} }}\n"
        for i in range(count)
    )
    return (
        header(photons)
        + orthographic((0, 2, 0), (0, -1, 0), (1, 0, 0), (0, 0, 1), 0.5)
        + f"light_source {{ <0,1000,0> rgb {1 / math.pi!r} parallel point_at 0 }}\n"
        + "plane { y,0 pigment { rgb 1 } finish { diffuse 1 } }\n"
        + boxes
    )


def _accounted(ledger: JsonObject) -> float:
    """What is stored, absorbed or escaped, over what was emitted, in red; what is cut for its depth is missing."""
    red = {name: ledger[name][0] for name in ("emitted", "stored", "absorbed", "escaped")}
    return (red["stored"] + red["absorbed"] + red["escaped"]) / red["emitted"]


LEDGER = Axis(
    name="photon_depth",
    quantity="clear panes that photons pass",
    unit="1",
    invariant="the ledger closes: what lossless panes let through is stored on the floor or has left the scene",
    values=tuple(walk(1, 2, 9)),
    scene=_deep_scene,
    sdl=_deep_sdl,
    expected=lambda panes: float("nan"),  # the reading at one pane
    tolerance={
        TRACER: Tolerance(1e-9, "the ledger adds 1e5 doubles: 1e-11 of rounding"),
        POVRAY: Tolerance(0.1, PHOTON_NOISE),
    },
    ledger=_accounted,
    photons=20_000,
    whole=True,
    limit={
        TRACER: "`transport.max_transmissions` may be at most 1000, two a pane; what is cut is booked as truncated",
        POVRAY: "the program itself crashes on photons so deep, below the 256 levels that it allows",
    },
)

LIGHT_AXES = (OFFSET, PHOTON_FLUX, LEDGER, BRIGHT, DIM)
