"""Faces that two solids share, one of which takes room from the other: a bore that is as long as its tube.

The scene means the face of the higher priority there. POV-Ray's set operations cannot tell which of two faces in one
place comes first [P 7], and leave a film of the lower solid or lose a face. So the higher solid reaches out by a little
where it shares a face; its order among the solids that share faces says by how much.
"""

from __future__ import annotations

from vitrail.geometry.world import World


def orders(world: World, begin: dict[int, int]) -> dict[int, int]:
    """By how many steps each solid must be larger than it is; ``begin`` has those that are larger already.

    A solid that shares a face with one of lower priority is a step larger than that one.
    """
    found = dict(begin)
    by_rank = sorted(range(len(world.solids)), key=world.priority)
    for place_in_order, higher in enumerate(by_rank):
        below = [lower for lower in by_rank[:place_in_order] if _is_flush(world, lower, higher)]
        if below:
            found[higher] = max(found.get(higher, 0), 1 + max(found.get(lower, 0) for lower in below))
    return found


def _is_flush(world: World, lower: int, higher: int) -> bool:
    """Whether a solid of higher priority takes room from another and shares a face with it."""
    first, second = world.solids[lower].faces, world.solids[higher].faces
    return any(a.is_same(b) for a in first for b in second) and world.displaces(higher, lower)
