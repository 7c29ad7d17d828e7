"""Room between surfaces that touch: POV-Ray loses one of two faces nearer than 1e-4 units [P 7].

A glass solid that touches another surface in a point or a line, or comes nearer than that, shrinks about its own middle
until there is a ``Gap``. Faces that lie on each other are a matter of ``contact``.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import assert_never

from vitrail.base.vector import Vec, add, scale, subtract, unit
from vitrail.geometry.distance import distances_to_surface
from vitrail.geometry.mesh_of import moved, solid_of
from vitrail.geometry.overlap import overlap
from vitrail.geometry.placement import Frame, Placed, place
from vitrail.geometry.surface_points import surface_points
from vitrail.lower.povray.bodies.normalise import Normalisation, thickness_of
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Object, Plane, Prism, Rectangle, Scene, Sphere


@dataclass(frozen=True)
class Gap:
    """``near``: units below which surfaces count as touching; ``made``: units of air that a touch becomes."""

    near: float
    made: float


FOR_LOOKS = Gap(near=1.1e-4, made=1.25e-4)
"""Beside clear glass, which asks for no light itself: more than looks and photons ignore, 1e-4 [P 7]. A shadow ray that
ignores the near face of such a solid is stopped by its far one."""
FOR_SHADOWS = Gap(near=1.2e-3, made=1.5e-3)
"""Beside glass that scatters too: its shadow rays would miss a sheet nearer than 1e-3 [P 7]. A ball is so near to one
in a few parts in a thousand of its shadow alone, and to shrink it moves all that is seen through it."""


@dataclass(frozen=True)
class Shrunk:
    """One object that was made smaller by ``depth_m`` all round, which is ``share`` of its thickness."""

    index: int
    depth_m: float
    share: float


@dataclass(frozen=True)
class Placement:
    """Every object where POV-Ray gets it, in the scene's order."""

    placed: tuple[Placed, ...]
    shrunk: tuple[Shrunk, ...]


def with_gaps(scene: Scene, units: Normalisation, contacts: Collection[tuple[int, int]] = ()) -> Placement:
    """Shrink every transmissive solid that touches something else, but for ``contacts``, which reach inside."""
    found: list[Placed] = []
    shrunk: list[Shrunk] = []
    for index, item in enumerate(scene.objects):
        placed = place(item)
        others = [
            other
            for position, other in enumerate(scene.objects)
            if position != index and (index, position) not in contacts and apart(item, other)
        ]
        material = scene.material_of(item)
        gap = FOR_SHADOWS if material.is_diffuse and not isinstance(placed.shape, Sphere) else FOR_LOOKS
        if material.is_transmissive and _touches_any(item, others, gap.near / units.scale):
            depth = gap.made / units.scale
            inner = smaller(placed, depth)
            if inner is not None:
                shrunk.append(Shrunk(index, depth, 2 * depth / thickness_of_placed(placed)))
                placed = inner
        found.append(placed)
    return Placement(tuple(found), tuple(shrunk))


def apart(a: Object, b: Object) -> bool:
    """Whether two objects are not meant to share room; those of different priority are cut instead."""
    return (a.priority or 0) == (b.priority or 0) or not overlap(a, b)


def _touches_any(item: Object, others: list[Object], near_m: float) -> bool:
    return any(surface_distance(item, other) < near_m for other in others)


def surface_distance(a: Object, b: Object) -> float:
    """The least distance found between the surfaces of two objects, metres."""
    placed_a, placed_b = place(a), place(b)
    from_a = distances_to_surface(b, surface_points(placed_a, placed_b))
    from_b = distances_to_surface(a, surface_points(placed_b, placed_a))
    return min([*from_a, *from_b], default=math.inf)


def thickness_of_placed(placed: Placed) -> float:
    """The smallest thickness of a solid, metres: of a mesh that of the walls under some of its faces."""
    if not isinstance(placed.shape, Mesh):
        return thickness_of(placed.shape)
    solid = solid_of(placed)
    return math.inf if solid is None else solid.thickness()


def smaller(placed: Placed, depth: float) -> Placed | None:
    """The shape with its surface moved inwards by ``depth`` metres; None for what is no solid."""
    shape = placed.shape
    match shape:
        case Sphere():
            return Placed(shape.model_copy(update={"radius": shape.radius - depth}), placed.frame)
        case Box():
            margin = (depth, depth, depth)
            update = {"min": add(shape.min, margin), "max": subtract(shape.max, margin)}
            return Placed(shape.model_copy(update=update), placed.frame)
        case Cylinder():
            inward = scale(unit(subtract(shape.to, shape.from_)), depth)
            ends = {"from_": add(shape.from_, inward), "to": subtract(shape.to, inward)}
            return Placed(shape.model_copy(update={**ends, "radius": shape.radius - depth}), placed.frame)
        case Cone() | Prism() | Lens():
            return _scaled(placed, 1 - 2 * depth / thickness_of(shape))
        case Mesh():
            return Placed(moved(shape, -depth), placed.frame)
        case Plane() | Rectangle() | Disc():
            return None
        case _:
            assert_never(shape)


def _scaled(placed: Placed, factor: float) -> Placed:
    """A cone, prism or lens scaled about its middle."""
    shape = placed.shape
    match shape:
        case Cone():
            middle = scale(add(shape.from_, shape.to), 0.5)

            def moved(point: Vec) -> Vec:
                return add(middle, scale(subtract(point, middle), factor))

            ends = {"from_": moved(shape.from_), "to": moved(shape.to)}
            radii = {"radius_from": shape.radius_from * factor, "radius_to": shape.radius_to * factor}
            return Placed(shape.model_copy(update={**ends, **radii}), placed.frame)
        case Prism():
            corners = shape.corners
            x, y = (sum(corner[axis] for corner in corners) / len(corners) for axis in (0, 1))
            profile = tuple(((a - x) * factor + x, (b - y) * factor + y) for a, b in corners)
            smaller = Prism(height=shape.height * factor, profile=profile)
            return Placed(smaller, placed.frame)
        case Lens():
            lengths = ("radius_front", "radius_back", "thickness", "diameter")
            update = {key: getattr(shape, key) * factor for key in lengths}
            return Placed(shape.model_copy(update=update), Frame(placed.frame.origin, placed.frame.rotation))
        case _:
            raise ValueError(f"a {type(shape).__name__} is not scaled here")
