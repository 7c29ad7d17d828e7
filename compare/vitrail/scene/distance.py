"""How far a point is from the surface of an object."""

from __future__ import annotations

from typing import assert_never

import numpy as np

from vitrail.scene.inside import depth_in
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Object, Plane, Prism, Rectangle, Sphere
from vitrail.scene.placement import place
from vitrail.scene.vector import Vec, cross, dot, length, scale, subtract, unit


def distance_to_surface(item: Object, point: Vec) -> float | None:
    """Distance in metres: zero on the surface, elsewhere at most the true one; None for a mesh, not read here."""
    shape = place(item).shape
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
            return None
        case _:
            assert_never(shape)


def _from_rectangle(shape: Rectangle, point: Vec) -> float:
    """How far a point is beyond the edges along u and along v, and above the plane."""
    away, u, v = subtract(point, shape.center), unit(shape.u), unit(shape.v)
    beyond_u = max(0.0, abs(dot(away, u)) - length(shape.u))
    beyond_v = max(0.0, abs(dot(away, v)) - length(shape.v))
    return length((beyond_u, beyond_v, dot(away, unit(cross(u, v)))))
