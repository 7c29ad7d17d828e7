"""Bodies whose faces lie on each other: light passes from one to the other with nothing between them.

A scene means that; POV-Ray loses one of two faces nearer than 1e-4 units [P 7]. So glass is made larger by a little
where a face of it lies on something. It then reaches into other glass, which takes the room by its priority, as glass
that overlaps does; or into a body that is not transparent, whose face then stands inside the glass. Bodies that touch
in a point or along a line are no matter of this: see ``gaps``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.flush import orders
from vitrail.lower.povray.bodies.normalise import Normalisation

REACH = 8e-4
"""Units by which glass reaches into what it lies on: twice the hair that its cut stays away [P 7]."""


@dataclass(frozen=True)
class Grown:
    """One solid that was made larger by ``depth_m`` all round, which is ``share`` of its thickness."""

    index: int
    depth_m: float
    share: float


@dataclass(frozen=True)
class Joined:
    """The world with its contacts as overlaps.

    ``under`` names the glasses that lie on each body that is none; ``pairs`` are two glasses, the one that gives way
    first.
    """

    world: World
    grown: tuple[Grown, ...]
    under: Mapping[int, tuple[int, ...]]
    pairs: frozenset[tuple[int, int]]

    @property
    def contacts(self) -> frozenset[tuple[int, int]]:
        """Every glass with what it reaches into, and the other way round for two glasses."""
        on_others = {(glass, other) for other, glasses in self.under.items() for glass in glasses}
        return self.pairs | {(higher, lower) for lower, higher in self.pairs} | on_others


def with_contacts(world: World, units: Normalisation) -> Joined:
    """Make glass reach into what its faces lie on; where two glasses meet, the lower priority, or the earlier one.

    Then make solids reach out that share a face with one they take room from.
    """
    found = [(index, other) for index, other in world.contacts if world.solids[index].grown(0.0) is not None]
    steps = orders(world, {index: 1 for index, _ in found})
    if not steps:
        return Joined(world, (), {}, frozenset())
    grown: dict[int, Grown] = {}
    larger: dict[int, Solid] = {}
    for index, count in steps.items():
        depth, solid = count * REACH / units.scale, world.solids[index]
        if (reaching := solid.grown(depth)) is not None:
            grown[index] = Grown(index, depth, 2 * depth / solid.thickness_m)
            larger[index] = reaching
    # Spread the priorities, so that one can be raised above another without reaching a third.
    step = len(world.solids) + 1
    ranks = [step * world.priority(index) for index in range(len(world.solids))]
    top = step + max(ranks)
    under: dict[int, tuple[int, ...]] = {}
    pairs = set()
    for index, other in found:
        if world.material(other).is_transmissive:
            pairs.add((index, other))
            ranks[other] = max(ranks[other], 1 + ranks[index])
        else:
            under[other] = (*under.get(other, ()), index)
            ranks[other] = top
    joined = world.with_solids(larger).with_priorities(ranks)
    return Joined(joined, tuple(grown.values()), under, frozenset(pairs))
