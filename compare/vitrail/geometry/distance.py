"""How far a point is from the surface of an object."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import assert_never

import numpy as np

from vitrail.base.vector import Vec, cross, dot, length, scale, subtract, unit
from vitrail.geometry.inside import depth_in
from vitrail.geometry.mesh_of import solid_of
from vitrail.geometry.placement import place
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Object, Plane, Prism, Rectangle, Sphere


def distances_to_surface(item: Object, points: Sequence[Vec]) -> list[float]:
    """``distance_to_surface`` of each point; infinite where it is not known."""
    placed = place(item)
    if isinstance(placed.shape, Mesh) and points and (solid := solid_of(placed)) is not None:
        return [float(each) for each in solid.distance(np.array(points, float))]
    found = [distance_to_surface(item, point) for point in points]
    return [math.inf if each is None else each for each in found]


def distance_to_surface(item: Object, point: Vec) -> float | None:
    """Distance in metres: zero on the surface, elsewhere at most the true one; None for a mesh without a full path."""
    placed = place(item)
    shape = placed.shape
    match shape:
        case Sphere() | Plane() | Box() | Cylinder() | Cone() | Prism() | Lens():
            return abs(float(depth_in(item, np.array([point], float))[0]))
        case Rectangle():
            return _from_rectangle(shape, point)
        case Disc():
            away, normal = subtract(point, shape.center), unit(shape.normal)
            height = dot(away, normal)
            aside = length(subtract(away, scale(normal, height)))
            return length((max(0.0, aside - shape.radius), height, 0.0))
        case Mesh():
            solid = solid_of(placed)
            return None if solid is None else float(solid.distance(np.array([point], float))[0])
        case _:
            assert_never(shape)


def _from_rectangle(shape: Rectangle, point: Vec) -> float:
    """How far a point is beyond the edges along u and along v, and above the plane."""
    away, u, v = subtract(point, shape.center), unit(shape.u), unit(shape.v)
    beyond_u = max(0.0, abs(dot(away, u)) - length(shape.u))
    beyond_v = max(0.0, abs(dot(away, v)) - length(shape.v))
    return length((beyond_u, beyond_v, dot(away, unit(cross(u, v)))))
