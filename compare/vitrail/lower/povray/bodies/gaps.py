"""Room between surfaces that touch: POV-Ray loses one of two faces nearer than 1e-4 units [P 7].

A glass solid that touches another surface in a point or a line, or comes nearer than that, shrinks about its own middle
until there is a ``Gap``. Faces that lie on each other are a matter of ``contact``.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from vitrail.geometry.distance import surface_distance
from vitrail.geometry.near_pairs import near_pairs
from vitrail.geometry.shapes.sphere import PlacedSphere
from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.normalise import Normalisation


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

    placed: tuple[Solid, ...]
    shrunk: tuple[Shrunk, ...]


def with_gaps(world: World, units: Normalisation, contacts: Collection[tuple[int, int]] = ()) -> Placement:
    """Shrink every transmissive solid that touches something else, but for ``contacts``, which reach inside."""
    found: list[Solid] = []
    shrunk: list[Shrunk] = []
    near = _near(world, max(FOR_LOOKS.near, FOR_SHADOWS.near) / units.scale)
    for index, solid in enumerate(world.solids):
        others = [other for other in near[index] if (index, other) not in contacts and apart(world, index, other)]
        material = world.material(index)
        gap = FOR_SHADOWS if material.is_diffuse and not isinstance(solid, PlacedSphere) else FOR_LOOKS
        if material.is_transmissive and _touches_any(world, index, others, gap.near / units.scale):
            depth = gap.made / units.scale
            smaller = solid.grown(-depth)
            if smaller is not None:
                shrunk.append(Shrunk(index, depth, 2 * depth / solid.thickness_m))
                solid = smaller
        found.append(solid)
    return Placement(tuple(found), tuple(shrunk))


def _near(world: World, near_m: float) -> list[list[int]]:
    """For every solid the others whose boxes come as near as that: no other touches it."""
    found: list[list[int]] = [[] for _ in world.solids]
    for first, second in near_pairs([solid.bounds for solid in world.solids], near_m):
        found[first].append(second)
        found[second].append(first)
    return [sorted(others) for others in found]


def apart(world: World, a: int, b: int) -> bool:
    """Whether two objects are not meant to share room; those of different priority are cut instead."""
    return world.priority(a) == world.priority(b) or not world.overlap(a, b)


def _touches_any(world: World, index: int, others: list[int], near_m: float) -> bool:
    return any(surface_distance(world.solids[index], world.solids[other]) < near_m for other in others)
