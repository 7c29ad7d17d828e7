"""One ray through the tracer, from a scene as text to the vertices it prints."""

from __future__ import annotations

import math
from typing import Any

from vitrail.base.vector import Vec
from vitrail.engines.tracer import Tracer
from vitrail.geometry.world import World
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import everything
from vitrail.plan.budget import settings_for
from vitrail.scene.load import load_text

Vertices = list[dict[str, Any]]

HEAD = """
vitrail: 1
camera: {position: [0, 0, 50], look_at: [0, 0, 0], fov_deg: 30}
image: {width: 8, height: 8}
lights: [{name: sun, directional: {direction: [0, -1, 0], irradiance: 1}}]
"""


def follow(
    body: str,
    origin: Vec,
    direction: Vec,
    *,
    band: int = 0,
    wavelength_nm: float | None = None,
    branch: str = "transmit",
) -> Vertices:
    """The vertices of the ray in the scene of these materials and objects, everything on."""
    scene = load_text(HEAD + body).scene
    world = World.of_scene(scene)
    plan = everything(world)
    lowered = lower_tracer(world, plan, settings_for(world, plan, "draft"), wavelength_nm=wavelength_nm)
    words = [",".join(repr(x) for x in vector) for vector in (origin, direction)]
    arguments = ["--origin", words[0], "--direction", words[1], "--branch", branch, "--band", str(band)]
    return Tracer().trace(lowered, arguments)["vertices"]


def direction_of(angle_deg: float) -> Vec:
    """In the plane of x and y, counted from +x towards +y."""
    return (math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg)), 0.0)


def down_at(angle_deg: float) -> Vec:
    """Downwards, at this angle from -y towards +x."""
    return (math.sin(math.radians(angle_deg)), -math.cos(math.radians(angle_deg)), 0.0)


def before(point: Vec, direction: Vec, distance: float) -> Vec:
    """Where a ray must start to pass ``point`` after ``distance``."""
    x, y, z = (p - distance * d for p, d in zip(point, direction, strict=True))
    return (x, y, z)


def angle_between(first: Vec, second: Vec) -> float:
    """Radians, to rounding at every size: from the cross and the inner product."""
    a, b = first, second
    cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    return math.atan2(math.hypot(*cross), sum(x * y for x, y in zip(a, b, strict=True)))


def turn(vertices: Vertices) -> float:
    """Radians between the way in and the way out, in the plane of x and y, positive counter-clockwise."""
    a, b = vertices[0]["direction_in"], vertices[-1]["direction_out"]
    return math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])


def sideways(vertices: Vertices) -> float:
    """How far the way out runs beside the way in, for parallel ways, metres."""
    first, last = vertices[0], vertices[-2]
    offset = [q - p for p, q in zip(first["point"], last["point"], strict=True)]
    along = sum(x * d for x, d in zip(offset, first["direction_in"], strict=True))
    return math.hypot(*(x - along * d for x, d in zip(offset, first["direction_in"], strict=True)))


def axis_crossing(vertices: Vertices) -> tuple[float, float]:
    """Of the last line: its least distance from the origin, signed, and the y at which it crosses the y axis."""
    point, way = vertices[-2]["point"], vertices[-1]["direction_out"]
    return (point[0] * way[1] - point[1] * way[0], point[1] - way[1] * point[0] / way[0])


def events(vertices: Vertices) -> str:
    return " ".join(vertex["event"] for vertex in vertices)
