"""Axes of length: how thin a pane, how large or small a ball, how far from the origin, how many panes in a row."""

from __future__ import annotations

import numpy as np

from vitrail.base.record import JsonObject
from vitrail.study.extremes.axis import POVRAY, TRACER, Axis, Ray, Tolerance
from vitrail.study.extremes.sdl_text import CLEAR, glowing_plane, header, orthographic
from vitrail.study.extremes.search import walk

HALF_FLOAT = "POV-Ray writes half floats: 5e-4 of rounding, and a lost face is a factor"


def last_throughput(vertices: list[JsonObject]) -> float:
    return float(vertices[-1]["throughput"][0])


# --- thickness ------------------------------------------------------------------------------------------------------


def _pane_scene(thickness: float) -> str:
    return f"""vitrail: 1
title: A tinted pane of thickness {thickness!r}
camera: {{kind: orthographic, position: [0, 0, -10], look_at: [0, 0, 0], height: 0.1}}
image: {{width: 4, height: 4}}
materials:
  pane: {{transmission: 0.5, ior: 1.5}}
  lamp: {{emission: 1}}
objects:
  - {{name: pane, box: {{min: [-1, -1, 0], max: [1, 1, {thickness!r}]}}, material: pane}}
  - {{name: lamp, plane: {{point: [0, 0, 5], normal: [0, 0, -1]}}, material: lamp}}
lights: []
"""


def _pane_sdl(thickness: float) -> str:
    return (
        header()
        + orthographic((0, 0, -10), (0, 0, 1), (1, 0, 0), (0, 1, 0), 0.1)
        + f"box {{ <-1,-1,0>,<1,1,{thickness!r}> pigment {{ rgb .5 filter 1 }} interior {{ ior 1.5 }} }}\n"
        + glowing_plane("z", 5)
    )


THICKNESS = Axis(
    name="thickness",
    quantity="thickness of a pane",
    unit="m",
    invariant="a pane with transmission 1/2 a face lets 1/4 through, however thin it is",
    values=tuple(walk(0.1, 0.1, 13)),
    scene=_pane_scene,
    sdl=_pane_sdl,
    expected=lambda thickness: 0.25,
    tolerance={
        TRACER: Tolerance(0.0, "two products by 1/2 are exact"),
        POVRAY: Tolerance(0.01, HALF_FLOAT),
    },
    ray=lambda thickness: Ray((0.01, 0.02, -10.0), (0.0, 0.0, 1.0), last_throughput),
    limit={POVRAY: "a face within 1e-4 units of the one just left is taken for it"},
)

# --- size -----------------------------------------------------------------------------------------------------------


def _ball_scene(radius: float) -> str:
    r = radius
    return f"""vitrail: 1
title: A glass ball of radius {r!r} before a checkered wall
camera: {{position: [0, 0, {-3 * r!r}], look_at: [0, 0, 0], fov_deg: 36}}
image: {{width: 32, height: 32}}
materials:
  glass: {{transmission: 0.5, ior: 1.5}}
  wall: {{emission: {{checker: {{colors: [[0.5, 0.25, 1], [1, 0.5, 0.25]], size: {r / 2!r}}}}}}}
objects:
  - {{name: ball, sphere: {{center: [0, 0, 0], radius: {r!r}}}, material: glass}}
  - {{name: wall, plane: {{point: [0, 0, {2 * r!r}], normal: [0, 0, -1]}}, material: wall}}
lights: []
"""


def _ball_sdl(radius: float) -> str:
    r = radius
    return (
        header()
        + f"camera {{ perspective location <0,0,{-3 * r!r}> direction z right x*.65 up y*.65 }}\n"
        + f"sphere {{ 0,{r!r} pigment {{ rgb .5 filter 1 }} interior {{ ior 1.5 }} }}\n"
        + f"plane {{ z,{2 * r!r} pigment {{ checker rgb <.5,.25,1> rgb <1,.5,.25> scale {r / 2!r} }}"
        + " finish { emission 1 } }\n"
    )


def _mean_of_channels(image: np.ndarray, value: float) -> float:
    """A number that changes when any part of the picture does: the mean weighted by place and channel."""
    rows, columns = np.mgrid[0 : image.shape[0], 0 : image.shape[1]]
    weight = (1 + rows + 2 * columns)[..., None] * np.array([1.0, 2.0, 4.0])
    return float((image * weight).sum() / weight.sum())


def _size_axis(name: str, quantity: str, factor: float, povray_limit: str) -> Axis:
    return Axis(
        name=name,
        quantity=quantity,
        unit="m",
        invariant="multiplying every length by a power of two changes no pixel",
        values=tuple(walk(1.0, factor, 10)),
        scene=_ball_scene,
        sdl=_ball_sdl,
        expected=lambda radius: float("nan"),  # the reading at the first value
        tolerance={
            TRACER: Tolerance(0.0, "powers of two are exact in binary arithmetic"),
            POVRAY: Tolerance(1e-3, "half floats round to 5e-4; a missing part of the ball is far more"),
        },
        read=_mean_of_channels,
        is_binary=True,
        pixels=32,
        limit={POVRAY: povray_limit},
    )


LARGE = _size_axis("large_scale", "radius of a ball, upwards", 8.0, "nothing is seen beyond 1e7 units")
SMALL = _size_axis("small_scale", "radius of a ball, downwards", 0.125, "faces nearer than 1e-4 units are lost")

# --- depth ----------------------------------------------------------------------------------------------------------


def _stack_scene(panes: float) -> str:
    count = int(panes)
    boxes = "\n".join(
        f"  - {{name: pane{i}, material: glass,"
        f" box: {{min: [-1, -1, {0.25 * i!r}], max: [1, 1, {0.25 * i + 0.125!r}]}}}}"
        for i in range(count)
    )
    return f"""vitrail: 1
title: {count} panes in a row
camera: {{kind: orthographic, position: [0, 0, -1], look_at: [0, 0, 0], height: 0.1}}
image: {{width: 4, height: 4}}
materials:
  glass: {{transmission: 1, ior: 1.5}}
  lamp: {{emission: 1}}
objects:
{boxes}
  - {{name: lamp, plane: {{point: [0, 0, {0.25 * count + 1!r}], normal: [0, 0, -1]}}, material: lamp}}
lights: []
transport: {{max_transmissions: {min(1000, 2 * count)}}}
"""


def _stack_sdl(panes: float) -> str:
    count = int(panes)
    boxes = "".join(
        f"box {{ <-1,-1,{0.25 * i!r}>,<1,1,{0.25 * i + 0.125!r}> {CLEAR} interior {{ ior 1.5 }} }}\n"
        for i in range(count)
    )
    camera = orthographic((0, 0, -1), (0, 0, 1), (1, 0, 0), (0, 1, 0), 0.1)
    return header() + camera + boxes + glowing_plane("z", 0.25 * count + 1)


DEPTH = Axis(
    name="depth",
    quantity="clear panes in a row",
    unit="1",
    invariant="any number of lossless panes passes all light",
    values=tuple(walk(1, 2, 9)),
    scene=_stack_scene,
    sdl=_stack_sdl,
    expected=lambda panes: 1.0,
    tolerance={
        TRACER: Tolerance(0.0, "products by 1 are exact"),
        POVRAY: Tolerance(1e-3, "half floats round to 5e-4"),
    },
    whole=True,
    limit={
        TRACER: "`transport.max_transmissions` may be at most 1000, two a pane; what is cut is booked as truncated",
        POVRAY: "`max_trace_level` is capped at 256, two a pane and one for what is behind",
    },
)

SIZE_AXES = (THICKNESS, LARGE, SMALL, DEPTH)
