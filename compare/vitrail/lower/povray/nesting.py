"""Solids that share room: the one of higher priority rules there, which POV-Ray says with its set operations.

POV-Ray keeps the media of a ray on a stack: entering the inner of two solids refracts by the ratio of their indices,
and so does leaving it [P 7]. That is right for a bubble inside a block. Where solids only overlap, the lower one is cut
by the higher one, made smaller by a hair, so that the faces of the higher one act and the hidden cut, at equal index,
does not. Air inside glass (index 1, no share lost) is no solid at all: it is cut out exactly and left out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vitrail.lower.povray.gaps import GAP, smaller
from vitrail.lower.povray.normalise import Normalisation
from vitrail.lower.povray.surface_points import surface_points
from vitrail.plan.plan import Plan
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.inside import depth_in, is_solid
from vitrail.scene.model import Material, Object, Scene
from vitrail.scene.overlap import overlap
from vitrail.scene.phenomenon import Phenomenon
from vitrail.scene.placement import Placed, place


@dataclass(frozen=True)
class Cut:
    """A higher solid taken out of a lower one: its index, and its shape, smaller by a hair unless it is air."""

    by: int
    placed: Placed
    is_exact: bool


@dataclass(frozen=True)
class Nesting:
    """``cuts`` of each object in the scene's order; ``omitted`` objects are air; ``shares_room`` have others inside."""

    cuts: tuple[tuple[Cut, ...], ...]
    omitted: frozenset[int]
    shares_room: frozenset[int]


def nesting_of(scene: Scene, units: Normalisation) -> Nesting:
    """Who is cut by whom."""
    air = frozenset(index for index, item in enumerate(scene.objects) if _is_air(scene, item))
    cuts, sharing = [], set()
    for index, item in enumerate(scene.objects):
        found: list[Cut] = []
        for other_index, other in enumerate(scene.objects):
            if other_index == index or not _displaces(scene, other, item):
                continue
            sharing.add(index)
            if other_index in air:
                found.append(Cut(other_index, place(other), is_exact=True))
            elif not _can_stay_nested(scene, item, other):
                inner = smaller(place(other), GAP / units.scale)
                found.append(Cut(other_index, inner or place(other), is_exact=inner is None))
        cuts.append(tuple(found))
    return Nesting(tuple(cuts), air, frozenset(sharing))


def _displaces(scene: Scene, higher: Object, lower: Object) -> bool:
    """Whether glass of a higher priority takes room from a solid."""
    if not (is_solid(higher) and is_solid(lower) and scene.material_of(higher).is_transmissive):
        return False
    return (higher.priority or 0) > (lower.priority or 0) and bool(overlap(higher, lower))


def _is_air(scene: Scene, item: Object) -> bool:
    """Whether a solid of glass only takes room away: index 1, everything passes."""
    material = scene.material_of(item)
    passes_all = material.ior == 1 and min(material.transmission) == 1 and max(absorption_per_m(material)) == 0
    return is_solid(item) and passes_all and (item.priority or 0) > 0


def _can_stay_nested(scene: Scene, outer: Object, inner: Object) -> bool:
    """Whether the stack alone is right: the inner one lies wholly inside, and the outer one absorbs nothing.

    POV-Ray takes absorption from the solid that is hit, so that of the outer one would be lost before the inner one.
    """
    if max(absorption_per_m(scene.material_of(outer))) > 0:
        return False
    points = surface_points(place(inner), place(outer))
    return bool(points) and bool((depth_in(outer, np.array(points, float)) > 0).all())


def is_lossless(material: Material) -> bool:
    """Whether a face with the same index on both sides takes nothing away: then a cut through such glass is unseen."""
    share = [r + t for r, t in zip(material.reflection, material.transmission, strict=True)]
    if material.fresnel:
        return min(share) >= 1 - 1e-12 and not material.is_diffuse
    return min(material.transmission) == 1


def needs_media(scene: Scene, plan: Plan, nesting: Nesting) -> bool:
    """Whether some absorbing glass has other solids inside."""
    materials = [scene.material_of(scene.objects[index]) for index in nesting.shares_room]
    return plan.requires(Phenomenon.ABSORPTION) and any(max(absorption_per_m(each)) > 0 for each in materials)
