"""How much room a thing takes: axis-aligned boxes in the world, possibly infinite.

Bounds answer only questions that are safe to answer with too large a box: *may* a light reach it, *may* the camera
see it. Nothing here is a hit test.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from itertools import product
from typing import assert_never

from vitrail.base.vector import Vec, add, dot, length, scale, subtract, unit
from vitrail.geometry.placement import Frame, place
from vitrail.scene.model import (
    Area,
    Box,
    Cone,
    Cylinder,
    Directional,
    Disc,
    Environment,
    Lens,
    Light,
    Mesh,
    Object,
    Patch,
    Plane,
    Point,
    Prism,
    Rectangle,
    Scene,
    Shape,
    Sphere,
    Spot,
)


@dataclass(frozen=True)
class Bounds:
    """A closed box in world coordinates, metres; infinite where the thing is."""

    low: Vec
    high: Vec

    @property
    def is_finite(self) -> bool:
        return all(math.isfinite(value) for value in self.low + self.high)

    @property
    def centre(self) -> Vec:
        return scale(add(self.low, self.high), 0.5)

    @property
    def radius_m(self) -> float:
        """Radius of the sphere around the box; infinite for infinite bounds."""
        return 0.5 * length(subtract(self.high, self.low)) if self.is_finite else math.inf

    @property
    def corners(self) -> tuple[Vec, ...]:
        return tuple(product(*zip(self.low, self.high, strict=True)))  # type: ignore[arg-type]


EVERYWHERE = Bounds((-math.inf,) * 3, (math.inf,) * 3)


def around(points: Iterable[Vec]) -> Bounds:
    """The smallest box that holds all points; at least one is needed."""
    columns = list(zip(*points, strict=True))
    low, high = [min(column) for column in columns], [max(column) for column in columns]
    return Bounds((low[0], low[1], low[2]), (high[0], high[1], high[2]))


def together(boxes: Iterable[Bounds]) -> Bounds:
    """The smallest box that holds all boxes; at least one is needed."""
    return around(point for box in boxes for point in (box.low, box.high))


@lru_cache(maxsize=4096)
def bounds_of(item: Object) -> Bounds:
    """The room an object takes in the world; a plane and a mesh (not read here) count as infinite."""
    placed = place(item)
    return bounds_of_shape(placed.shape, placed.frame)


def bounds_of_shape(shape: Shape, frame: Frame) -> Bounds:
    """The room a shape takes in ``frame``."""
    match shape:
        case Sphere():
            return _grown(shape.center, (shape.radius,) * 3)
        case Plane() | Mesh():
            return EVERYWHERE
        case Rectangle():
            return _parallelogram(shape.center, shape.u, shape.v)
        case Disc():
            return _disc(shape.center, shape.normal, shape.radius)
        case Box():
            local = Bounds(shape.min, shape.max)
            return around(frame.point(corner) for corner in local.corners)
        case Cylinder():
            axis = subtract(shape.to, shape.from_)
            return together((_disc(shape.from_, axis, shape.radius), _disc(shape.to, axis, shape.radius)))
        case Cone():
            axis = subtract(shape.to, shape.from_)
            return together((_disc(shape.from_, axis, shape.radius_from), _disc(shape.to, axis, shape.radius_to)))
        case Prism():
            half = shape.height / 2
            return around(frame.point((x, y, z)) for x, y in shape.corners for z in (-half, half))
        case Lens():
            half_width, half_depth = shape.diameter / 2, _lens_half_depth(shape)
            local = Bounds((-half_width, -half_width, -half_depth), (half_width, half_width, half_depth))
            return around(frame.point(corner) for corner in local.corners)
        case _:
            assert_never(shape)


def bounds_of_patch(patch: Patch) -> Bounds:
    return _parallelogram(patch.center, patch.u, patch.v)


def bounds_of_light(light: Light) -> Bounds:
    """The room an emitter takes; sky and sun count as infinite."""
    emitter = light.emitter
    match emitter:
        case Directional() | Environment():
            return EVERYWHERE
        case Point() | Spot():
            return Bounds(emitter.position, emitter.position)
        case Area():
            return bounds_of_shape(emitter.shape, Frame())
        case _:
            assert_never(emitter)


def extent_of(scene: Scene) -> Bounds:
    """The finite part of a scene: objects, lamps and observed patches; camera and viewed point if all is infinite."""
    boxes = [bounds_of(item) for item in scene.objects]
    boxes += [bounds_of_light(light) for light in scene.lights]
    boxes += [bounds_of_patch(observation.patch) for observation in scene.observe]
    finite = [box for box in boxes if box.is_finite]
    if not finite or together(finite).radius_m == 0:
        finite.append(around((scene.camera.position, scene.camera.look_at)))
    return together(finite)


def _grown(center: Vec, half: Vec) -> Bounds:
    return Bounds(subtract(center, half), add(center, half))


def _parallelogram(center: Vec, u: Vec, v: Vec) -> Bounds:
    return _grown(center, (abs(u[0]) + abs(v[0]), abs(u[1]) + abs(v[1]), abs(u[2]) + abs(v[2])))


def _disc(center: Vec, normal: Vec, radius: float) -> Bounds:
    """A disc reaches radius sqrt(1 - n_i^2) along axis i."""
    n = unit(normal)
    reach = [radius * math.sqrt(max(0.0, (1 - n[i]) * (1 + n[i]))) for i in range(3)]
    return _grown(center, (reach[0], reach[1], reach[2]))


def _lens_half_depth(lens: Lens) -> float:
    """Half the depth at the axis, or at the rim where a concave face reaches farther out."""
    sags = [_sag(radius, lens.diameter / 2) for radius in (lens.radius_front, lens.radius_back) if radius < 0]
    return lens.thickness / 2 + max(sags, default=0.0)


def _sag(radius: float, half_width: float) -> float:
    """Depth of a spherical face over its half width; a face cannot be wider than its sphere."""
    size = abs(radius)
    reach = min(half_width, size)
    return reach * reach / (size + math.sqrt(max(0.0, (size - reach) * (size + reach))))


def plane_distance(plane: Plane, point: Vec) -> float:
    """Signed distance of a point from a plane, positive on the side of its normal."""
    return dot(unit(plane.normal), subtract(point, plane.point))
