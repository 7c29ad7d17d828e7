"""A scene as things in space: made once from what was loaded, and handed on to check, plan and back ends.

Whatever is asked about a pair of solids, or needs the file of a mesh, is found out once for a world, when it is first
asked; nothing about geometry is remembered anywhere else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from vitrail.base.changed import unchecked
from vitrail.base.vector import Vec
from vitrail.geometry.bounds import Bounds, around, together
from vitrail.geometry.camera import View
from vitrail.geometry.contact import is_area, shared_points
from vitrail.geometry.lamp import bounds_of_light, place_of
from vitrail.geometry.near_pairs import near_pairs
from vitrail.geometry.overlap import Overlap, overlap
from vitrail.geometry.patch import bounds_of_patch
from vitrail.geometry.placement import place
from vitrail.geometry.solid import Solid
from vitrail.geometry.touch import TOUCH
from vitrail.scene.load import Loaded
from vitrail.scene.model import Material, Object, Scene


@dataclass(frozen=True, eq=False)
class World:
    """The geometry of one scene; ``solids`` are its objects, placed, in the same order.

    ``folder`` is where the files that the scene names are sought; without it they stay as named and are not read.
    ``loaded`` holds the lines of the file, for messages; a scene made in memory has none.
    """

    scene: Scene
    solids: tuple[Solid, ...]
    folder: Path | None = None
    loaded: Loaded | None = None
    _overlaps: dict[tuple[Solid, Solid], Overlap] = field(default_factory=dict, repr=False)

    @classmethod
    def of(cls, loaded: Loaded) -> World:
        """The world of a scene file."""
        return replace(cls.of_scene(loaded.scene, loaded.path.parent), loaded=loaded)

    @classmethod
    def of_scene(cls, scene: Scene, folder: Path | None = None) -> World:
        """The world of a scene that was made in memory."""
        return cls(scene, tuple(place(item, folder) for item in scene.objects), folder)

    # --- other worlds ------------------------------------------------------------------------------------------------

    def with_scene(self, scene: Scene) -> World:
        """The world of a changed scene, with the same lines for messages; objects that stay are not placed again."""
        known = {id(item): solid for item, solid in zip(self.scene.objects, self.solids, strict=True)}
        solids = tuple(known.get(id(item)) or place(item, self.folder) for item in scene.objects)
        return replace(self, scene=scene, solids=solids)

    def with_priorities(self, priorities: Sequence[int]) -> World:
        """The same solids with other ranks among those that overlap; they may lie beyond those that a file may give."""
        ranked = zip(self.scene.objects, priorities, strict=True)
        objects = tuple(unchecked(item, priority=priority) for item, priority in ranked)
        return replace(self, scene=unchecked(self.scene, objects=objects))

    def with_solids(self, changed: Mapping[int, Solid]) -> World:
        """The world with some solids in the place of others; the objects of the scene keep their numbers."""
        return replace(self, solids=tuple(changed.get(index, solid) for index, solid in enumerate(self.solids)))

    # --- one object ---------------------------------------------------------------------------------------------------

    @cached_property
    def _index(self) -> dict[str, int]:
        return {item.name: index for index, item in enumerate(self.scene.objects)}

    def solid(self, item: Object) -> Solid:
        """Where an object of the scene is."""
        return self.solids[self._index[item.name]]

    def bounds(self, item: Object) -> Bounds:
        return self.solid(item).bounds

    def material(self, index: int) -> Material:
        return self.scene.material_of(self.scene.objects[index])

    def priority(self, index: int) -> int:
        return self.scene.objects[index].priority or 0

    def is_room(self, index: int) -> bool:
        """Whether a closed object holds the camera and at least one lamp: its inner face is the scene."""
        solid = self.solids[index]
        places = [place for light in self.scene.lights if (place := place_of(light)) is not None]
        return solid.contains(self.scene.camera.position) and any(solid.contains(place) for place in places)

    # --- pairs of objects ---------------------------------------------------------------------------------------------

    def overlap(self, a: int, b: int) -> Overlap:
        """How far two objects reach into each other."""
        pair = self.solids[a], self.solids[b]
        if pair not in self._overlaps:
            self._overlaps[pair] = overlap(*pair)
        return self._overlaps[pair]

    def displaces(self, higher: int, lower: int) -> bool:
        """Whether glass of a higher priority takes room from a solid."""
        if not (self.solids[higher].is_closed and self.solids[lower].is_closed):
            return False
        rules = self.material(higher).is_transmissive and self.priority(higher) > self.priority(lower)
        return rules and bool(self.overlap(higher, lower))

    @cached_property
    def contacts(self) -> tuple[tuple[int, int], ...]:
        """Pairs of a glass and what a face of it lies on; of two glasses the one that gives way comes first."""
        glasses = {index for index, solid in enumerate(self.solids) if self._is_glass(index) and solid.is_closed}
        ranks = {glass: (self.priority(glass), glass) for glass in glasses}

        def gives_way(glass: int, other: int) -> bool:
            return glass in glasses and (other not in glasses or ranks[glass] < ranks[other])

        slack = TOUCH * max((max(1.0, solid.number_size_m) for solid in self.solids), default=1.0)
        near = list(near_pairs([solid.bounds for solid in self.solids], slack))
        both = sorted([*near, *((second, first) for first, second in near)])
        return tuple(pair for pair in both if gives_way(*pair) and self._lie_on_each_other(*pair))

    def _is_glass(self, index: int) -> bool:
        return self.material(index).is_transmissive

    def _lie_on_each_other(self, a: int, b: int) -> bool:
        """Whether the surfaces of two solids that share no room share an area."""
        shared = shared_points(self.solids[a], self.solids[b])
        return is_area(shared) and not self.overlap(a, b)

    # --- the whole ----------------------------------------------------------------------------------------------------

    @cached_property
    def view(self) -> View:
        """The camera with the size of its picture."""
        return View.of(self.scene.camera, self.scene.image)

    @cached_property
    def extent(self) -> Bounds:
        """The finite part of the scene: objects, lamps, observed patches; camera and viewed point if all is infinite.

        A mesh is no part of it, as its file is not read.
        """
        boxes = [solid.bounds for solid in self.solids]
        boxes += [bounds_of_light(light) for light in self.scene.lights]
        boxes += [bounds_of_patch(observation.patch) for observation in self.scene.observe]
        finite = [box for box in boxes if box.is_finite]
        if not finite or together(finite).radius_m == 0:
            finite.append(around((self.scene.camera.position, self.scene.camera.look_at)))
        return together(finite)

    def medium_around(self, points: Sequence[Vec], but: int | None = None) -> int | None:
        """The glass that rules where all points are, but for one object; None in air, and among equals the first."""
        ruling: int | None = None
        for index, solid in enumerate(self.solids):
            if index == but or not solid.is_closed or not self.material(index).is_transmissive:
                continue
            holds = bool(solid.is_inside(np.array(points, float)).all())
            if holds and (ruling is None or self.priority(index) > self.priority(ruling)):
                ruling = index
        return ruling
