"""What of a scene is small: thin bodies and walls, little rectangles, and the room before the camera.

POV-Ray's tolerances are absolute. Below them it loses one of two faces, a whole polygon, or all that the camera sees.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from vitrail.base.vector import length
from vitrail.geometry.shapes.axial import PlacedCone, PlacedCylinder
from vitrail.geometry.shapes.box import PlacedBox
from vitrail.geometry.shapes.flat import PlacedRectangle
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.shapes.sphere import PlacedSphere
from vitrail.geometry.touch import TOUCH
from vitrail.geometry.world import World
from vitrail.lower.povray.refusals.refusal import Refusals
from vitrail.scene.diagnostic import Diagnostic

SMALLEST_FEATURE = 0.01
"""Thickness in units that every tolerance of POV-Ray resolves by a factor of ten [P 7]."""
ROOM_BEFORE_CAMERA = 1e-3
"""Units from the camera to the nearest surface: what is nearer than 1e-4 is not seen at all [P 7]."""
HOLLOWED = (PlacedSphere, PlacedCylinder, PlacedCone, PlacedBox)
"""Shapes whose walls are looked at."""
ALIKE = 3
"""Points of a wall: fewer lie near the line in which two surfaces cross, where nothing is thin."""


@dataclass(frozen=True)
class Feature:
    """Something of ``size_m`` that needs ``least`` POV-Ray units; ``path`` is its place in the scene."""

    size_m: float
    least: float
    noun: str
    remedy: str
    path: tuple[str | int, ...]

    @property
    def needs_m(self) -> float:
        """The thickness that needs as large a scale."""
        return self.size_m * (SMALLEST_FEATURE / self.least)

    def refused(self, refusals: Refusals, diameter_m: float, factor: float) -> Diagnostic:
        """At its line, why no scale holds it."""
        what = (
            f"{self.noun} of {self.size_m:.3g} m in a scene of {diameter_m:.3g} m is {self.size_m * factor:.2g} POV-Ray"
            f" units, below the {self.least:g} that its absolute tolerances resolve"
        )
        return refusals.at(what, self.remedy, *self.path)


def features_of(world: World) -> Iterator[Feature]:
    """Thickness and walls of every solid but meshes, the size of rectangles, and what the camera is nearest to."""
    for index, solid in enumerate(world.solids):
        path = ("objects", index)
        if isinstance(solid, PlacedRectangle):
            # POV-Ray drops polygons of less than 1e-5 square units, however long they are.
            side = 2 * math.sqrt(length(solid.shape.u) * length(solid.shape.v))
            yield Feature(
                side, SMALLEST_FEATURE, "a rectangle", "make it larger, or the scene with its lamps smaller", path
            )
        if not isinstance(solid, PlacedMesh) and math.isfinite(thickness := solid.thickness_m):
            for size in (thickness, *_walls(world, index)):
                yield Feature(size, SMALLEST_FEATURE, "a feature", "make it thicker or the scene smaller", path)
    yield from _before_camera(world)


def _before_camera(world: World) -> Iterator[Feature]:
    """The way from the camera to the nearest surface, unless it stands on it."""
    place = world.scene.camera.position
    for solid in world.solids:
        away = solid.distance(place)
        if math.isfinite(away) and away > TOUCH * max(solid.number_size_m, length(place)):
            remedy = "move it away, make the scene smaller, or use a plane for a ground that is a huge ball"
            yield Feature(
                away, ROOM_BEFORE_CAMERA, "the camera's distance from a surface", remedy, ("camera", "position")
            )


def _walls(world: World, index: int) -> Iterator[float]:
    """What is left of a solid, metres, beside one of its own shape that takes room from it: tubes, bubbles, tanks.

    Its thickness is that of the room where three points of its surface are as near.
    """
    solid = world.solids[index]
    for other, taker in enumerate(world.solids):
        is_hollow = isinstance(solid, HOLLOWED) and type(taker) is type(solid) and other != index
        if not is_hollow or not world.displaces(other, index):
            continue
        points = np.array(solid.surface_points(taker), float).reshape(-1, 3)
        outside = points[~np.asarray(taker.is_inside(points), bool)] if len(points) else points
        slack = TOUCH * max(solid.number_size_m, taker.number_size_m)
        # Faces that lie on each other leave no wall.
        away = sorted(each for each in taker.distances([(x, y, z) for x, y, z in outside.tolist()]) if each > slack)
        if len(away) >= ALIKE:
            yield away[ALIKE - 1]
