"""Axes of a single ball: far from the origin, and in a white furnace with ever more index."""

from __future__ import annotations

import numpy as np

from vitrail.base.record import JsonObject
from vitrail.study.extremes.axis import POVRAY, TRACER, Axis, Ray, Tolerance
from vitrail.study.extremes.sdl_text import CLEAR, FRESNEL, header, orthographic
from vitrail.study.extremes.search import walk

# --- translation ----------------------------------------------------------------------------------------------------

OFF_AXIS = 0.5
"""Where the ray meets the ball of radius 1, from its axis."""


def _moved_scene(offset: float) -> str:
    x = offset
    return f"""vitrail: 1
title: A ball {offset!r} m from the origin
camera: {{kind: orthographic, position: [{x + OFF_AXIS!r}, 0, 3], look_at: [{x + OFF_AXIS!r}, 0, 0], height: 0.01}}
image: {{width: 4, height: 4}}
materials:
  glass: {{transmission: 1, ior: 1.5}}
  lamp: {{emission: 1}}
objects:
  - {{name: ball, sphere: {{center: [{x!r}, 0, 0], radius: 1}}, material: glass}}
  - {{name: lamp, plane: {{point: [0, 0, -4], normal: [0, 0, 1]}}, material: lamp}}
lights: []
"""


def _moved_sdl(offset: float) -> str:
    """A gradient from -2 to 2 about the axis tells where the ray lands 4 m behind the centre."""
    x = offset
    return (
        header()
        + orthographic((x + OFF_AXIS, 0, 3), (0, 0, -1), (1, 0, 0), (0, 1, 0), 1e-6)
        + f"sphere {{ <{x!r},0,0>,1 {CLEAR} interior {{ ior 1.5 }} }}\n"
        + "plane { z,-4 pigment { gradient x color_map { [0 rgb 0][1 rgb 1] } scale 4"
        + f" translate x*{x - 2!r} }} finish {{ emission 1 }} }}\n"
    )


def _slope(vertices: list[JsonObject]) -> float:
    """The slope of the ray behind the ball: a direction, because places carry the size of the offset."""
    x, _, z = vertices[-2]["direction_out"]
    return x / abs(z)


TRANSLATION = Axis(
    name="translation",
    quantity="distance of a ball from the origin",
    unit="m",
    invariant="moving a scene changes no path: a ball turns the ray at half its radius by 2 (i - r)",
    values=tuple(walk(1.0, 10.0, 12)),
    scene=_moved_scene,
    sdl=_moved_sdl,
    expected=lambda offset: float("nan"),  # the reading at the first value
    tolerance={
        TRACER: Tolerance(1e-9, "the ray is followed relative to the ball; 1e-9 leaves seven of sixteen digits"),
        POVRAY: Tolerance(0.01, "half floats read the gradient to 5e-4"),
    },
    read=lambda image, offset: float(np.mean(image)),
    ray=lambda offset: Ray((offset + OFF_AXIS, 0.0, 3.0), (0.0, 0.0, -1.0), _slope),
)

# --- furnace --------------------------------------------------------------------------------------------------------

MOST_BOUNCES = 1000


def _furnace_scene(ior: float) -> str:
    return f"""vitrail: 1
title: A ball of index {ior!r} in a white furnace
camera: {{kind: orthographic, position: [0.3, 0.2, 3], look_at: [0.3, 0.2, 0], height: 0.01}}
image: {{width: 2, height: 2}}
materials:
  glass: {{transmission: 1, ior: {ior!r}, fresnel: true}}
objects:
  - {{name: ball, sphere: {{center: [0, 0, 0], radius: 1}}, material: glass}}
lights:
  - {{name: furnace, environment: {{radiance: 1}}}}
transport: {{max_reflections: {MOST_BOUNCES}, max_transmissions: {MOST_BOUNCES}}}
"""


def _furnace_sdl(ior: float) -> str:
    return (
        header()
        + orthographic((0.3, 0.2, 3), (0, 0, -1), (1, 0, 0), (0, 1, 0), 0.01)
        + "background { rgb 1 }\n"
        + f"sphere {{ 0,1 {CLEAR} {FRESNEL} interior {{ ior {ior!r} }} }}\n"
    )


FURNACE = Axis(
    name="furnace",
    quantity="n of a ball in a white furnace",
    unit="1",
    invariant="glass that keeps no light cannot be seen where all directions shine alike",
    values=tuple(walk(1.5, 2.0, 20)),
    scene=_furnace_scene,
    sdl=_furnace_sdl,
    expected=lambda ior: 1.0,
    tolerance={
        TRACER: Tolerance(
            1e-3, "branches below 1e-6 of the pixel are cut, and 1000 reflections: 8e-4 together at worst"
        ),
        POVRAY: Tolerance(2e-3, "half floats round to 5e-4; what 256 levels leave inside is 1 / (256 e) = 1.4e-3"),
    },
    pixels=2,
)

BALL_AXES = (TRANSLATION, FURNACE)
