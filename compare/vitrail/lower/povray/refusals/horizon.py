"""Planes that go on beyond what POV-Ray sees: 1e7 units from where a ray starts it finds nothing, and says nothing.

Before an ordinary camera that is a line below its horizon. The rays of a camera of nearly 180 degrees meet even the
plane in front of it so far away.
"""

from __future__ import annotations

import numpy as np

from vitrail.base.vector import unit
from vitrail.geometry.camera import View
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals

FARTHEST_HIT = 1e7
"""Units from the start of a ray to the farthest thing it finds [P 7]."""
MOST_UNSEEN = 1e-3
"""Share of the picture that may lie beyond."""
GRID = 64
"""Rays along either side of the picture."""


def refuse_unseen_planes(world: World, units: Normalisation, refusals: Refusals) -> None:
    """Raises NotTranslatable where planes are too far in more than a thousandth of the picture."""
    unseen = _unseen(world, units)
    if unseen > MOST_UNSEEN:
        what = f"in {unseen:.1%} of the picture a plane is farther away than POV-Ray sees"
        remedy = "lower `fov_deg`, or end the plane: use a rectangle"
        raise NotTranslatable([refusals.at(what, remedy, "camera")])


def _unseen(world: World, units: Normalisation) -> float:
    """The share of rays on a grid whose first plane is too far."""
    view = View.of(world.scene.camera, world.scene.image)
    places = (np.arange(GRID) + 0.5) / GRID * 2 - 1
    rays = [view.ray(x, y) for y in places for x in places]
    starts, ways = np.array([start for start, _ in rays]), np.array([unit(way) for _, way in rays])
    nearest = np.full(len(rays), np.inf)
    for solid in world.solids:
        if isinstance(solid, PlacedPlane):
            normal = np.array(unit(solid.shape.normal))
            towards = ways @ normal
            with np.errstate(divide="ignore", invalid="ignore"):
                away = (np.array(solid.shape.point) - starts) @ normal / towards
            nearest = np.where((away > 0) & (away < nearest), away, nearest)
    return float((np.isfinite(nearest) & (nearest * units.scale > FARTHEST_HIT)).mean())
