"""Solids that share room: the one of higher priority rules there, which POV-Ray says with its set operations.

POV-Ray keeps the media of a ray on a stack. Entering a solid inside another refracts by the ratio of their indices and
mirrors by it; leaving the inner one refracts right, but mirrors nothing, because its Fresnel term compares the inner
index with itself [M]. So no face is ever left for another glass: the lower solid is cut by the higher one, made smaller
by a hair, and light always enters. Going up it enters at the face of the higher one, going down at the cut, which has
the looks of the higher one; the face that is crossed second, at equal index, is clear from its inside.

Air inside glass (index 1, no share lost) is no solid at all: it is cut out exactly and left out.
"""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.scene.absorption import absorption_per_m

HAIR = 4e-4
"""Units between the face of a higher solid and the cut in a lower one: four times what POV-Ray can tell apart [P 7]."""


@dataclass(frozen=True)
class Cut:
    """A higher solid taken out of a lower one: its index, and its shape, smaller by a hair unless it is air.

    Where the two only touch, the scene has two faces in one place, and both take their share.
    """

    by: int
    placed: Solid
    is_air: bool
    is_contact: bool


@dataclass(frozen=True)
class Nesting:
    """``cuts`` of each object in the scene's order; ``hosts`` are the glasses it cuts; ``omitted`` objects are air.

    Air is no host: it has no face of its own that light could cross first.
    """

    cuts: tuple[tuple[Cut, ...], ...]
    hosts: tuple[tuple[int, ...], ...]
    omitted: frozenset[int]


def nesting_of(world: World, units: Normalisation, contacts: frozenset[tuple[int, int]] = frozenset()) -> Nesting:
    """Who is cut by whom; ``contacts`` are lower and higher solids that overlap in POV-Ray only."""
    solids = range(len(world.solids))
    air = frozenset(index for index in solids if _is_air(world, index))
    cuts = tuple(
        tuple(
            _cut(world, by, by in air, (index, by) in contacts, units)
            for by in solids
            if by != index and world.displaces(by, index)
        )
        for index in solids
    )
    hosts = tuple(
        tuple(
            lower
            for lower, found in enumerate(cuts)
            if lower not in air and any(cut.by == index for cut in found) and world.material(lower).is_transmissive
        )
        for index in solids
    )
    return Nesting(cuts, hosts, air)


def _cut(world: World, by: int, is_air: bool, is_contact: bool, units: Normalisation) -> Cut:
    solid = world.solids[by]
    inner = None if is_air else solid.grown(-HAIR / units.scale)
    return Cut(by, inner or solid, is_air, is_contact)


def _is_air(world: World, index: int) -> bool:
    """Whether a solid of glass only takes room away: index 1, everything passes."""
    material = world.material(index)
    passes_all = material.ior == 1 and min(material.transmission) == 1 and max(absorption_per_m(material)) == 0
    return world.solids[index].is_closed and passes_all and world.priority(index) > 0
