"""Faces that two solids share, one of which takes room from the other: a bore that is as long as its tube.

The scene means the face of the higher priority there. POV-Ray's set operations cannot tell which of two faces in one
place comes first [P 7], and leave a film of the lower solid or lose a face. So the higher solid reaches out by a little
where it shares a face; its order among the solids that share faces says by how much.
"""

from __future__ import annotations

import math
from typing import assert_never

from vitrail.base.vector import Vec, dot, length, scale, subtract, unit
from vitrail.geometry.inside import is_solid
from vitrail.geometry.overlap import TOUCH, overlap
from vitrail.geometry.placement import Placed, place
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Plane, Prism, Rectangle, Scene, Sphere

Face = tuple[str, Vec, Vec, float]
"""A whole surface: its kind, a unit direction (outward normal, axis), a point (of the axis, the middle), a size."""
ORIGIN: Vec = (0.0, 0.0, 0.0)


def orders(scene: Scene, begin: dict[int, int]) -> dict[int, int]:
    """By how many steps each solid must be larger than it is; ``begin`` has those that are larger already.

    A solid that shares a face with one of lower priority is a step larger than that one.
    """
    found = dict(begin)
    by_rank = sorted(range(len(scene.objects)), key=lambda index: scene.objects[index].priority or 0)
    for place_in_order, higher in enumerate(by_rank):
        below = [lower for lower in by_rank[:place_in_order] if _is_flush(scene, lower, higher)]
        if below:
            found[higher] = max(found.get(higher, 0), 1 + max(found.get(lower, 0) for lower in below))
    return found


def _is_flush(scene: Scene, lower: int, higher: int) -> bool:
    """Whether a solid of higher priority takes room from another and shares a face with it."""
    one, two = scene.objects[lower], scene.objects[higher]
    if not (is_solid(one) and is_solid(two) and scene.material_of(two).is_transmissive):
        return False
    if not (one.priority or 0) < (two.priority or 0):
        return False
    first, second = faces_of(place(one)), faces_of(place(two))
    return any(_are_one(a, b) for a in first for b in second) and bool(overlap(one, two))


def faces_of(placed: Placed) -> list[Face]:
    """The surfaces around a solid, in the world; a mesh and what is no solid give none."""
    shape, frame = placed.shape, placed.frame
    match shape:
        case Sphere():
            return [("sphere", ORIGIN, shape.center, shape.radius)]
        case Plane():
            return [_flat(shape.normal, shape.point)]
        case Box():
            axes: tuple[Vec, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
            ends = [(axis, shape.max) for axis in axes] + [(scale(axis, -1), shape.min) for axis in axes]
            return [_flat(frame.direction(axis), frame.point(corner)) for axis, corner in ends]
        case Cylinder() | Cone():
            return _turned(shape)
        case Prism():
            half = shape.height / 2
            sides = [
                _flat(frame.direction((b[1] - a[1], a[0] - b[0], 0.0)), frame.point((a[0], a[1], 0.0)))
                for a, b in zip(shape.corners, shape.corners[1:] + shape.corners[:1], strict=True)
            ]
            caps = [_flat(frame.direction((0.0, 0.0, z)), frame.point((0.0, 0.0, z * half))) for z in (-1.0, 1.0)]
            return [*sides, *caps]
        case Lens():
            axis = frame.direction((0.0, 0.0, 1.0))
            found: list[Face] = [("cylinder", _either_way(axis), frame.origin, shape.diameter / 2)]
            for side, radius in ((-1.0, shape.radius_front), (1.0, shape.radius_back)):
                vertex: Vec = (0.0, 0.0, side * shape.thickness / 2)
                if radius == 0:
                    found.append(_flat(scale(axis, side), frame.point(vertex)))
                else:
                    middle = frame.point((0.0, 0.0, vertex[2] - side * radius))
                    found.append(("sphere", ORIGIN, middle, radius))
            return found
        case Rectangle() | Disc() | Mesh():
            return []
        case _:
            assert_never(shape)


def _turned(shape: Cylinder | Cone) -> list[Face]:
    """The two ends and the side of a body of revolution; a cone's side by its tip and its slope."""
    along = subtract(shape.to, shape.from_)
    axis = unit(along)
    ends = [_flat(scale(axis, -1), shape.from_), _flat(axis, shape.to)]
    if isinstance(shape, Cylinder):
        return [*ends, ("cylinder", _either_way(axis), shape.from_, shape.radius)]
    slope = (shape.radius_to - shape.radius_from) / length(along)
    tip = subtract(shape.from_, scale(axis, shape.radius_from / slope))
    return [*ends, ("cone", axis if slope > 0 else scale(axis, -1), tip, abs(slope))]


def _flat(normal: Vec, point: Vec) -> Face:
    outward = unit(normal)
    return ("plane", outward, point, 0.0)


def _either_way(axis: Vec) -> Vec:
    """One of the two directions of an axis, the same for both."""
    return axis if axis > (-axis[0], -axis[1], -axis[2]) else scale(axis, -1)


def _are_one(a: Face, b: Face) -> bool:
    """Whether two surfaces are the same one, seen from the same side."""
    slack = TOUCH * max(1.0, length(a[2]), length(b[2]), abs(a[3]))
    if a[0] != b[0] or math.dist(a[1], b[1]) > TOUCH or abs(a[3] - b[3]) > slack:
        return False
    between = subtract(b[2], a[2])
    match a[0]:
        case "plane":
            return abs(dot(a[1], between)) <= slack
        case "cylinder":
            return length(subtract(between, scale(a[1], dot(a[1], between)))) <= slack
        case _:
            return length(between) <= slack
