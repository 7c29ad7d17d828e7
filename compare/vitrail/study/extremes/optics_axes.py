"""Axes of refraction: the index towards 1, far above and below it; grazing incidence; the critical angle."""

from __future__ import annotations

import math

import numpy as np

from vitrail.study.extremes.axis import Axis, Ray, Tolerance
from vitrail.study.extremes.sdl_text import CLEAR, FRESNEL, glowing_plane, header, orthographic
from vitrail.study.extremes.search import walk

N_GLASS = 1.5
DIAGONAL = math.sqrt(0.5)
FAR = 6e6
"""Length of the light path in glass, m: as long as POV-Ray's 1e7 limit allows, so that small deflections show."""


def _half_space(ior: str, extra: str = "", fresnel: bool = False, emission: float = 1.0, distance: float = 1.0) -> str:
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


def _tangent(vertices: list[dict]) -> float:
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


# --- index ----------------------------------------------------------------------------------------------------------


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
    scene=lambda excess: _half_space(repr(1 + excess)),
    sdl=_near_one_sdl,
    expected=_straightness,
    tolerance={
        "tracer": Tolerance(0.01, "n itself is a double: n - 1 is known to 2e-4 at 1e-12"),
        "povray": Tolerance(0.01, "half floats read the gradient to 5e-4 of 4 deflections"),
    },
    read=lambda image, excess: (1 - float(np.mean(image))) * 4 * _straightness(excess),
    ray=lambda excess: Ray((-1.0, 0.0, 1.0), (DIAGONAL, 0.0, -DIAGONAL), lambda v: 1 - _tangent(v)),
    limit={"povray": "the index is stored in single precision"},
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
    scene=lambda ior: _half_space(repr(ior)),
    sdl=lambda ior: _slant_sdl(ior, 1.0, 0.0, 2 * _tangent_in(ior)),
    expected=_tangent_in,
    tolerance={
        "tracer": Tolerance(1e-9, "eta (d + c1 n) keeps relative digits; 1e-9 leaves seven of sixteen"),
        "povray": Tolerance(0.01, "half floats read the gradient to 5e-4"),
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
    scene=lambda ior: _half_space(repr(ior)),
    sdl=lambda ior: _steep_sdl(ior),
    expected=lambda ior: math.tan(math.asin(0.5)),
    tolerance={
        "tracer": Tolerance(1e-9, "sin and cos of the incidence are doubles; 1e-9 leaves seven of sixteen digits"),
        "povray": Tolerance(0.01, "half floats read the gradient to 5e-4"),
    },
    read=lambda image, ior: 2 * float(np.mean(image)),
    ray=lambda ior: Ray((-ior / 2, 0.0, math.sqrt(1 - ior**2 / 4)), _steep(ior), _tangent),
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


# --- incidence ------------------------------------------------------------------------------------------------------


def fresnel_transmittance(n1: float, c1: float, n2: float, c2: float) -> float:
    """T for unpolarised light from n1 into n2, formed directly and not as 1 - R [O 2.6]."""
    product = 4 * n1 * c1 * n2 * c2
    return 0.5 * (product / (n1 * c1 + n2 * c2) ** 2 + product / (n2 * c1 + n1 * c2) ** 2)


def _grazing(elevation_deg: float) -> tuple[float, float]:
    """(sine, cosine) of the incidence that is ``elevation_deg`` above the face."""
    return math.cos(math.radians(elevation_deg)), math.sin(math.radians(elevation_deg))


def _grazing_share(elevation_deg: float) -> float:
    sine, cosine = _grazing(elevation_deg)
    inner = math.sqrt(1 - (sine / N_GLASS) ** 2)
    return fresnel_transmittance(1.0, cosine, N_GLASS, inner)


def _grazing_sdl(elevation_deg: float) -> str:
    sine, cosine = _grazing(elevation_deg)
    return (
        header()
        + orthographic((-sine, 0, cosine), (sine, 0, -cosine), (cosine, 0, sine), (0, 1, 0), 1e-9)
        + f"plane {{ z,0 {CLEAR} {FRESNEL} interior {{ ior {N_GLASS} }} }}\n"
        + glowing_plane("z", -0.5, 1 / _grazing_share(elevation_deg))
    )


GRAZING = Axis(
    name="grazing",
    quantity="elevation above a face",
    unit="deg",
    invariant="the share that enters is Fresnel's T, small as it becomes",
    values=tuple(walk(10.0, 0.1, 9)),
    scene=lambda elevation: _half_space(repr(N_GLASS), fresnel=True, emission=1 / _grazing_share(elevation)),
    sdl=_grazing_sdl,
    expected=lambda elevation: 1.0,
    tolerance={
        "tracer": Tolerance(1e-9, "T is formed directly; the sine of the elevation is a double, 1e-9 leaves margin"),
        "povray": Tolerance(0.01, "half floats round to 5e-4, the lamp is brightened by 1/T"),
    },
    ray=lambda elevation: Ray(
        (-_grazing(elevation)[0], 0.0, _grazing(elevation)[1]),
        (_grazing(elevation)[0], 0.0, -_grazing(elevation)[1]),
        lambda vertices: float(vertices[0]["T"]) / _grazing_share(elevation),
    ),
    limit={"povray": "T is formed as 1 - R, which has lost its digits"},
)


def _critical(below: float) -> tuple[float, float, float]:
    """(sine, cosine) inside and cosine outside, ``below`` under the critical angle relative in the sine.

    The outer cosine follows from the sine as it is stored, so that rounding of the input is not charged to the engine.
    """
    sine = (1 - below) / N_GLASS
    outer_sine = N_GLASS * sine
    return sine, math.sqrt((1 - sine) * (1 + sine)), math.sqrt(max(0.0, (1 - outer_sine) * (1 + outer_sine)))


def _critical_share(below: float) -> float:
    _, inner, outer = _critical(below)
    return fresnel_transmittance(N_GLASS, inner, 1.0, outer)


def _critical_scene(below: float) -> str:
    return f"""vitrail: 1
title: Leaving glass close to the critical angle
camera: {{kind: orthographic, position: [0, 0, -1], look_at: [0, 0, 0], height: 0.1}}
image: {{width: 4, height: 4}}
materials:
  glass: {{transmission: 1, ior: {N_GLASS}, fresnel: true}}
  lamp: {{emission: {1 / _critical_share(below)!r}}}
objects:
  - {{name: glass, plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}, material: glass}}
  - {{name: lamp, plane: {{point: [0, 0, 0.01], normal: [0, 0, -1]}}, material: lamp}}
lights: []
"""


def _critical_sdl(below: float) -> str:
    sine, cosine, _ = _critical(below)
    return (
        header()
        + orthographic((-sine, 0, -cosine), (sine, 0, cosine), (cosine, 0, -sine), (0, 1, 0), 1e-12)
        + f"plane {{ z,0 {CLEAR} {FRESNEL} interior {{ ior {N_GLASS} }} }}\n"
        + glowing_plane("z", 0.01, 1 / _critical_share(below))
    )


CRITICAL = Axis(
    name="critical_angle",
    quantity="distance from the critical angle, relative in the sine",
    unit="1",
    invariant="the share that leaves is Fresnel's T up to the critical angle",
    values=tuple(walk(0.1, 0.1, 11)),
    scene=_critical_scene,
    sdl=_critical_sdl,
    expected=lambda below: 1.0,
    tolerance={
        "tracer": Tolerance(0.01, "a sine is a double: cos_t is known to u / (2 eps), 6e-5 at 1e-12 [O 2.7]"),
        "povray": Tolerance(0.01, "half floats round to 5e-4, the lamp is brightened by 1/T"),
    },
    ray=lambda below: Ray(
        (-_critical(below)[0], 0.0, -_critical(below)[1]),
        (_critical(below)[0], 0.0, _critical(below)[1]),
        lambda vertices: float(vertices[0]["T"]) / _critical_share(below),
    ),
    limit={"povray": "the sine is rounded on the way"},
)

OPTICS_AXES = (INDEX_TO_ONE, INDEX_HUGE, INDEX_TINY, GRAZING, CRITICAL)
