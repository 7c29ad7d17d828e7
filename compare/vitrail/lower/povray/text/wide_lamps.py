"""How many small lights a lamp with an area needs: as many as tell what is near that it is no cloud of points.

The light of a lattice whose points stand s apart differs from that of the lamp, at a distance h, by some .06 (s / h)^2:
measured under discs of half to ten times h in radius, with 21 and 89 points. What counts is what lies straight before
the lamp. Beside its edge a wall or table has spots in a strip as narrow as s alone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from vitrail.base.vector import unit
from vitrail.geometry.solid import Solid
from vitrail.geometry.touch import TOUCH
from vitrail.lower.povray.text.emitters import Emitter

ERROR = 0.06
"""Root mean square relative error at s = h, before the sign of its halves cancels any."""
CLOSEST = 0.4
"""s / h that is aimed at: an error of 1 %."""
MOST_LIGHTS = 233
"""Small lights of one lamp in each half image: a shadow ray to each from every place that is seen."""
COARSEST = 2.0
"""s / h beyond which a lamp is refused: a quarter too bright or too dark."""
STEPS = 48
"""Steps along a way; each is as long as nothing is nearer."""
ARRIVED = 1e-3
"""Distance from a surface over the way gone from which on the way counts as ended."""
BEYOND_M = 1e12
"""Where a way ends that nothing stops."""


@dataclass(frozen=True)
class Closeness:
    """How near a lamp is to what it lights: the points of a lattice on it, in metres, over the distance."""

    area_m2: float
    nearest_m: float

    def step(self, count: int) -> float:
        """s / h with so many points."""
        return math.sqrt(self.area_m2 / count) / self.nearest_m

    @property
    def wanted(self) -> int:
        """The points that bring s / h down to what is aimed at."""
        return math.ceil(self.area_m2 / (CLOSEST * self.nearest_m) ** 2)


def closeness(lamp: Solid, area_m2: float, parts: list[Emitter], solids: tuple[Solid, ...]) -> Closeness:
    """Asks whatever is near first, and only where that is too near what lies before the lamp."""
    places = np.array([part.position for part in parts])
    found = Closeness(area_m2, float(_nearest(places, solids).min(initial=math.inf)))
    if found.wanted <= len(parts):
        return found
    normal = np.array(unit(parts[0].direction))
    return Closeness(
        area_m2, min(_nearest_known(lamp, places[0], normal, solids), _nearest_met(places, normal, solids))
    )


def _nearest(places: np.ndarray, solids: tuple[Solid, ...]) -> np.ndarray:
    """The distance of the nearest surface from each of (n, 3) places, at most."""
    points = [(x, y, z) for x, y, z in places.tolist()]
    away = [solid.distances(points) for solid in solids]
    return np.array(away).min(axis=0) if away else np.full(len(points), math.inf)


def _nearest_known(lamp: Solid, place: np.ndarray, normal: np.ndarray, solids: tuple[Solid, ...]) -> float:
    """The least height of corners, rims and other known points of surfaces that lie over the lamp's outline."""
    nearest = math.inf
    for solid in solids:
        points = solid.surface_points(lamp)
        heights = ((np.array(points, float).reshape(-1, 3) - place) @ normal).tolist()
        slack = TOUCH * max(solid.number_size_m, lamp.number_size_m)
        over = [
            height
            for height, away in zip(heights, lamp.distances(points), strict=True)
            if height > slack and away <= height + slack
        ]
        nearest = min([nearest, *over])
    return nearest


def _nearest_met(places: np.ndarray, normal: np.ndarray, solids: tuple[Solid, ...]) -> float:
    """The least way straight on from the lamp to a surface: it goes on by as much as nothing is nearer."""
    gone = np.zeros(len(places))
    for _ in range(STEPS):
        gone = np.minimum(gone + _nearest(places + gone[:, None] * normal, solids), BEYOND_M)
    arrived = _nearest(places + gone[:, None] * normal, solids) < ARRIVED * gone
    return float(gone[arrived].min(initial=math.inf))
