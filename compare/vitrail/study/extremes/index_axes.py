"""Axes of the index: towards 1, far above and far below it."""

from __future__ import annotations

import math

import numpy as np

from vitrail.base.record import JsonObject
from vitrail.study.extremes.axis import POVRAY, TRACER, Axis, Ray, Tolerance
from vitrail.study.extremes.sdl_text import CLEAR, header, orthographic
from vitrail.study.extremes.search import walk

N_GLASS = 1.5
DIAGONAL = math.sqrt(0.5)
FAR = 6e6
"""Length of the light path in glass, m: as long as POV-Ray's 1e7 limit allows, so that small deflections show."""


def half_space(ior: str, extra: str = "", fresnel: bool = False, emission: float = 1.0, distance: float = 1.0) -> str:
    """Glass below z = 0 (the plane's inside), with a lamp inside it."""
    return f"""vitrail: 1
title: One face of glass{extra}
camera: {{kind: orthographic, position: [0, 0, 1], look_at: [0, 0, 0], height: 0.1}}
image: {{width: 4, height: 4}}
materials:
  glass: {{transmission: 1, ior: {ior}, fresnel: {str(fresnel).lower()}}}
  lamp: {{emission: {emission!r}}}
objects:
  - {{name: glass, plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}, material: glass}}
  - {{name: lamp, plane: {{point: [0, 0, {-distance!r}], normal: [0, 0, 1]}}, material: lamp}}
lights: []
"""


def _tangent(vertices: list[JsonObject]) -> float:
    """Tangent of the refracted angle from the face's normal (the z axis)."""
    x, y, z = vertices[0]["direction_out"]
    return math.hypot(x, y) / abs(z)


def _slant_sdl(ior: float, depth: float, low: float, high: float) -> str:
    """A ray at 45 degrees enters glass at the origin; a gradient at z = -depth tells x between ``low`` and ``high``."""
    q, width = DIAGONAL, high - low
    return (
        header()
        + orthographic((-1, 0, 1), (q, 0, -q), (q, 0, q), (0, 1, 0), 1e-9)
        + f"box {{ <-1e7,-1,-1e7>,<1e7,1,0> {CLEAR} interior {{ ior {ior!r} }} }}\n"
        + f"plane {{ z,{-depth!r} pigment {{ gradient x color_map {{ [0 rgb 0][1 rgb 1] }} scale {width!r}"
        + f" translate x*{low!r} }} finish {{ emission 1 }} }}\n"
    )


def _straightness(excess: float) -> float:
    """1 - tan(theta_t) for 45 degrees into n = 1 + excess, in a form that keeps its digits: tan = s / sqrt(1 - s^2)."""
    n2_minus_1 = excess * (2 + excess)
    # tan(theta_t) = 1 / sqrt(2 n^2 - 1), so 1 - tan = (r - 1) / r with r = sqrt(1 + 2 (n^2 - 1)).
    root = math.sqrt(1 + 2 * n2_minus_1)
    return 2 * n2_minus_1 / (root * (root + 1))


def _near_one_depth(excess: float) -> float:
    return min(1 / excess, FAR)


def _near_one_sdl(excess: float) -> str:
    depth = _near_one_depth(excess)
    deflection = depth * _straightness(excess)
    return _slant_sdl(1 + excess, depth, depth - 4 * deflection, depth)


INDEX_TO_ONE = Axis(
    name="index_to_one",
    quantity="n - 1",
    unit="1",
    invariant="light at 45 degrees is deflected by 1 - tan(theta_t), however little that is",
    values=tuple(walk(0.1, 0.1, 11)),
    scene=lambda excess: half_space(repr(1 + excess)),
    sdl=_near_one_sdl,
    expected=_straightness,
    tolerance={
        TRACER: Tolerance(0.01, "n itself is a double: n - 1 is known to 2e-4 at 1e-12"),
        POVRAY: Tolerance(0.01, "half floats read the gradient to 5e-4 of 4 deflections"),
    },
    read=lambda image, excess: (1 - float(np.mean(image))) * 4 * _straightness(excess),
    ray=lambda excess: Ray((-1.0, 0.0, 1.0), (DIAGONAL, 0.0, -DIAGONAL), lambda v: 1 - _tangent(v)),
    limit={POVRAY: "the index is stored in single precision"},
)


def _tangent_in(ior: float) -> float:
    """tan(theta_t) for 45 degrees into ``ior``: s / sqrt(n^2 - s^2)."""
    return DIAGONAL / math.sqrt((ior - DIAGONAL) * (ior + DIAGONAL))


INDEX_HUGE = Axis(
    name="index_huge",
    quantity="n",
    unit="1",
    invariant="light at 45 degrees is refracted to tan(theta_t) = s / sqrt(n^2 - s^2)",
    values=tuple(walk(1.5, 10.0, 8)),
    scene=lambda ior: half_space(repr(ior)),
    sdl=lambda ior: _slant_sdl(ior, 1.0, 0.0, 2 * _tangent_in(ior)),
    expected=_tangent_in,
    tolerance={
        TRACER: Tolerance(1e-9, "eta (d + c1 n) keeps relative digits; 1e-9 leaves seven of sixteen"),
        POVRAY: Tolerance(0.01, "half floats read the gradient to 5e-4"),
    },
    read=lambda image, ior: float(np.mean(image)) * 2 * _tangent_in(ior),
    ray=lambda ior: Ray((-1.0, 0.0, 1.0), (DIAGONAL, 0.0, -DIAGONAL), _tangent),
)

INDEX_TINY = Axis(
    name="index_tiny",
    quantity="n, below 1",
    unit="1",
    invariant="light is refracted away from the normal, to sin(theta_t) = 1/2 where it came in at asin(n / 2)",
    values=tuple(walk(0.5, 0.1, 8)),
    scene=lambda ior: half_space(repr(ior)),
    sdl=lambda ior: _steep_sdl(ior),
    expected=lambda ior: math.tan(math.asin(0.5)),
    tolerance={
        TRACER: Tolerance(1e-9, "sin and cos of the incidence are doubles; 1e-9 leaves seven of sixteen digits"),
        POVRAY: Tolerance(0.01, "half floats read the gradient to 5e-4"),
    },
    read=lambda image, ior: 2 * float(np.mean(image)),
    ray=lambda ior: Ray((-ior / 2, 0.0, math.sqrt(1 - ior**2 / 4)), _steep(ior), _tangent),
    limit={POVRAY: "sines below 3e-8 are lost, as they are when formed from a cosine"},
)


def _steep(ior: float) -> tuple[float, float, float]:
    return (ior / 2, 0.0, -math.sqrt(1 - ior**2 / 4))


def _steep_sdl(ior: float) -> str:
    sine, _, minus_cosine = _steep(ior)
    cosine = -minus_cosine
    return (
        header()
        + orthographic((-sine, 0, cosine), (sine, 0, -cosine), (cosine, 0, sine), (0, 1, 0), 1e-12)
        + f"box {{ <-1e3,-1,-1e3>,<1e3,1,0> {CLEAR} interior {{ ior {ior!r} }} }}\n"
        + "plane { z,-1 pigment { gradient x color_map { [0 rgb 0][1 rgb 1] } scale 2 } finish { emission 1 } }\n"
    )


INDEX_AXES = (INDEX_TO_ONE, INDEX_HUGE, INDEX_TINY)
