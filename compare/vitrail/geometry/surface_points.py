"""Points on a surface at which a touch with another one shows: corners, edges, rims, and the near sides of balls."""

from __future__ import annotations

import math
from itertools import product
from typing import assert_never

from vitrail.base.vector import Vec, add, length, scale, subtract
from vitrail.geometry.mesh_of import solid_of
from vitrail.geometry.placement import Placed
from vitrail.geometry.surface import frame_of
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Plane, Prism, Rectangle, Sphere

STEPS = (-1.0, -0.5, 0.0, 0.5, 1.0)
"""Places along an edge, from end to end."""
RIM_POINTS = 16
AXES: tuple[Vec, ...] = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))


def surface_points(placed: Placed, towards: Placed) -> list[Vec]:
    """World points on ``placed``; a ball also gives the points that face ``towards``. A plane gives none."""
    shape, frame = placed.shape, placed.frame
    match shape:
        case Sphere():
            ways = [*AXES, *_ways_to(towards, shape.center)]
            return [add(shape.center, scale(way, shape.radius / length(way))) for way in ways]
        case Rectangle():
            return [add(shape.center, add(scale(shape.u, a), scale(shape.v, b))) for a, b in product(STEPS, STEPS)]
        case Disc():
            return _rim(shape.center, shape.normal, shape.radius)
        case Box():
            return [frame.point(point) for point in _box(shape)]
        case Cylinder():
            axis = subtract(shape.to, shape.from_)
            return [*_rim(shape.from_, axis, shape.radius), *_rim(shape.to, axis, shape.radius)]
        case Cone():
            axis = subtract(shape.to, shape.from_)
            return [*_rim(shape.from_, axis, shape.radius_from), *_rim(shape.to, axis, shape.radius_to)]
        case Prism():
            return [frame.point(point) for point in _prism(shape)]
        case Lens():
            half = shape.thickness / 2
            vertices: list[Vec] = [(0.0, 0.0, -half), (0.0, 0.0, half)]
            rim = _rim((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), shape.diameter / 2)[1:]
            return [frame.point(point) for point in [*vertices, *rim]]
        case Mesh():
            solid = solid_of(placed)
            return [] if solid is None else [(x, y, z) for x, y, z in solid.surface_points().tolist()]
        case Plane():
            return []
        case _:
            assert_never(shape)


def _ways_to(other: Placed, point: Vec) -> list[Vec]:
    """Directions in which another shape may be nearest to a point: its normals, or its middle."""
    shape, frame = other.shape, other.frame
    match shape:
        case Plane() | Disc():
            return [shape.normal, scale(shape.normal, -1)]
        case Rectangle():
            u, v = shape.u, shape.v
            normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            return [normal, scale(normal, -1)]
        case Sphere():
            away = subtract(shape.center, point)
            return [away, scale(away, -1)] if length(away) > 0 else []
        case Box() | Prism() | Lens():
            return [frame.direction(axis) for axis in AXES]
        case Cylinder() | Cone():
            axis = subtract(shape.to, shape.from_)
            u, v = frame_of(axis)
            return [axis, scale(axis, -1), u, v, scale(u, -1), scale(v, -1)]
        case Mesh():
            return []
        case _:
            assert_never(shape)


def _box(box: Box) -> list[Vec]:
    """A grid on the six faces, in the box's own axes."""
    middle, half = scale(add(box.min, box.max), 0.5), scale(subtract(box.max, box.min), 0.5)
    found = []
    for a, b, c in product(STEPS, STEPS, STEPS):
        if 1.0 in (abs(a), abs(b), abs(c)):
            found.append(add(middle, (a * half[0], b * half[1], c * half[2])))
    return found


def _rim(center: Vec, normal: Vec, radius: float) -> list[Vec]:
    """The middle of a disc and points on its edge."""
    u, v = frame_of(normal)
    turns = [2 * math.pi * step / RIM_POINTS for step in range(RIM_POINTS)]
    edge = [add(center, add(scale(u, radius * math.cos(turn)), scale(v, radius * math.sin(turn)))) for turn in turns]
    return [center, *edge]


def _prism(prism: Prism) -> list[Vec]:
    """Corners and middles of the edges, at both ends and half way."""
    corners = prism.corners
    outline = []
    for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
        outline += [a, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)]
    return [(x, y, z) for x, y in outline for z in (-prism.height / 2, 0.0, prism.height / 2)]
