"""Axes of incidence: grazing a face, and close to the critical angle."""

from __future__ import annotations

import math

from vitrail.study.extremes.axis import POVRAY, TRACER, Axis, Ray, Tolerance
from vitrail.study.extremes.index_axes import N_GLASS, half_space
from vitrail.study.extremes.sdl_text import CLEAR, FRESNEL, glowing_plane, header, orthographic
from vitrail.study.extremes.search import walk


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
    scene=lambda elevation: half_space(repr(N_GLASS), fresnel=True, emission=1 / _grazing_share(elevation)),
    sdl=_grazing_sdl,
    expected=lambda elevation: 1.0,
    tolerance={
        TRACER: Tolerance(1e-9, "T is formed directly; the sine of the elevation is a double, 1e-9 leaves margin"),
        POVRAY: Tolerance(0.01, "half floats round to 5e-4, the lamp is brightened by 1/T"),
    },
    ray=lambda elevation: Ray(
        (-_grazing(elevation)[0], 0.0, _grazing(elevation)[1]),
        (_grazing(elevation)[0], 0.0, -_grazing(elevation)[1]),
        lambda vertices: float(vertices[0]["T"]) / _grazing_share(elevation),
    ),
    limit={POVRAY: "T is formed as 1 - R, which has lost its digits"},
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
        TRACER: Tolerance(0.01, "a sine is a double: cos_t is known to u / (2 eps), 6e-5 at 1e-12 [O 2.7]"),
        POVRAY: Tolerance(0.01, "half floats round to 5e-4, the lamp is brightened by 1/T"),
    },
    ray=lambda below: Ray(
        (-_critical(below)[0], 0.0, -_critical(below)[1]),
        (_critical(below)[0], 0.0, _critical(below)[1]),
        lambda vertices: float(vertices[0]["T"]) / _critical_share(below),
    ),
    limit={POVRAY: "the sine is rounded on the way"},
)

INCIDENCE_AXES = (GRAZING, CRITICAL)
