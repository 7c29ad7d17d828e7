"""Bodies whose faces lie on each other: light passes from one to the other with nothing between them.

A scene means that; POV-Ray loses one of two faces nearer than 1e-4 units [P 7]. So glass is made larger by a little
where a face of it lies on something. It then reaches into other glass, which takes the room by its priority, as glass
that overlaps does; or into a body that is not transparent, whose face then stands inside the glass. Bodies that touch
in a point or along a line are no matter of this: see ``gaps``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from vitrail.base.changed import changed
from vitrail.base.vector import Vec, length
from vitrail.geometry.distance import distances_to_surface
from vitrail.geometry.inside import is_solid
from vitrail.geometry.overlap import TOUCH, overlap
from vitrail.geometry.placement import Frame, Placed, place
from vitrail.geometry.surface_points import surface_points
from vitrail.lower.povray.bodies.flush import orders
from vitrail.lower.povray.bodies.gaps import smaller, thickness_of_placed
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.scene.model import Object, Scene

REACH = 8e-4
"""Units by which glass reaches into what it lies on: twice the hair that its cut stays away [P 7]."""
AREA = 1e-3
"""Share of a contact's length that its width must have to be an area."""
NO_TURN = Frame((0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))


@dataclass(frozen=True)
class Grown:
    """One solid that was made larger by ``depth_m`` all round, which is ``share`` of its thickness."""

    index: int
    depth_m: float
    share: float


@dataclass(frozen=True)
class Joined:
    """The scene with its contacts as overlaps.

    ``under`` names the glasses that lie on each body that is none; ``pairs`` are two glasses, the one that gives way
    first.
    """

    scene: Scene
    grown: tuple[Grown, ...]
    under: Mapping[int, tuple[int, ...]]
    pairs: frozenset[tuple[int, int]]

    @property
    def contacts(self) -> frozenset[tuple[int, int]]:
        """Every glass with what it reaches into, and the other way round for two glasses."""
        on_others = {(glass, other) for other, glasses in self.under.items() for glass in glasses}
        return self.pairs | {(higher, lower) for lower, higher in self.pairs} | on_others


def with_contacts(scene: Scene, units: Normalisation) -> Joined:
    """Make glass reach into what its faces lie on; where two glasses meet, the lower priority, or the earlier one.

    Then make solids reach out that share a face with one they take room from.
    """
    found = [(index, other) for index, other in touching(scene) if _larger(scene.objects[index], 1.0) is not None]
    steps = orders(scene, {index: 1 for index, _ in found})
    if not steps:
        return Joined(scene, (), {}, frozenset())
    # Spread the priorities, so that one can be raised above another without reaching a third.
    step = len(scene.objects) + 1
    objects = [item.model_copy(update={"priority": step * (item.priority or 0)}) for item in scene.objects]
    top = step + max(item.priority or 0 for item in objects)
    grown: dict[int, Grown] = {}
    for index, count in steps.items():
        depth = count * REACH / units.scale
        larger = _larger(scene.objects[index], depth)
        if larger is not None:
            grown[index] = Grown(index, depth, 2 * depth / thickness_of_placed(place(scene.objects[index])))
            objects[index] = changed(objects[index], shape=larger.shape)
    under: dict[int, tuple[int, ...]] = {}
    pairs = set()
    for index, other in found:
        if scene.material_of(scene.objects[other]).is_transmissive:
            pairs.add((index, other))
            higher = max(objects[other].priority or 0, 1 + (objects[index].priority or 0))
            objects[other] = objects[other].model_copy(update={"priority": higher})
        else:
            under[other] = (*under.get(other, ()), index)
            objects[other] = objects[other].model_copy(update={"priority": top})
    return Joined(scene.model_copy(update={"objects": tuple(objects)}), tuple(grown.values()), under, frozenset(pairs))


def touching(scene: Scene) -> list[tuple[int, int]]:
    """Pairs of a glass and what it lies on; of two glasses the one that gives way comes first."""
    glasses = [i for i, item in enumerate(scene.objects) if is_solid(item) and scene.material_of(item).is_transmissive]
    found = []
    for index in glasses:
        for other, item in enumerate(scene.objects):
            rank, its_rank = ((scene.objects[i].priority or 0, i) for i in (index, other))
            gives_way = other not in glasses or rank < its_rank
            if other != index and gives_way and _lies_on(scene.objects[index], item):
                found.append((index, other))
    return found


def _lies_on(a: Object, b: Object) -> bool:
    """Whether the surfaces of two bodies that share no room share an area."""
    placed_a, placed_b = place(a), place(b)
    points_a, points_b = surface_points(placed_a, placed_b), surface_points(placed_b, placed_a)
    shared = [*_on(b, points_a), *_on(a, points_b)]
    if len(shared) < 3 or overlap(a, b):
        return False
    spread = np.linalg.svd(np.subtract(shared, np.mean(shared, axis=0)), compute_uv=False)
    return bool(spread[1] > AREA * spread[0])


def _on(item: Object, points: list[Vec]) -> list[Vec]:
    """The points that lie on the surface of a body."""
    away = distances_to_surface(item, points)
    return [point for point, each in zip(points, away, strict=True) if each <= TOUCH * max(1.0, length(point))]


def _larger(item: Object, depth: float) -> Placed | None:
    """The shape in its own axes with its surface moved outwards; None for what has no size of its own."""
    return smaller(Placed(item.shape, NO_TURN), -depth)
