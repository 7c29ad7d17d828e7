"""Bring a scene to the size that POV-Ray's absolute tolerances were made for, and back.

POV-Ray ignores hits nearer than 1e-4, shadows nearer than 1e-3 and everything beyond 1e7 units, and stores photon
positions in single precision [P 7]. A scene is moved to the origin where it lies far away, and multiplied by a power of
two, so that no digit is lost: lengths in the scene description are units = (metres - centre) * scale.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.vector import Vec, length, scale, subtract
from vitrail.geometry.bounds import together
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.curvature import curved_receivers, lost_share
from vitrail.lower.povray.bodies.features import SMALLEST_FEATURE, features_of
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals

LARGEST_EXTENT = 64.0
"""Extent in units that a scene is brought to (at most, and more than half of it)."""
SMALLEST_EXTENT = 8.0
"""The same where photons fall on curved surfaces, if it must be: smaller, gaps and hairs become visible lengths."""
BENT_SHARE = 0.01
"""Share of a photon disc that a curved surface may lose before the scene is made smaller; an opal ball lost 23 %."""
WIDEST_EXTENT = 8192.0
"""Extent in units up to which thin features may push the scale: single precision still places photons to 5e-4 units."""
SMALLEST_IN_METRES = 1.0
"""Extent in metres from which a scene may stay in metres: gaps are then 1e-4 of it."""
FARTHEST_CAMERA = 1.0e5
"""Distance of the camera in units up to which images are exact [P 7]."""


@dataclass(frozen=True)
class Normalisation:
    """units = (metres - centre) * scale, with ``scale`` a power of two; the scene is ``extent`` units across."""

    centre: Vec
    scale: float
    extent: float

    def point(self, metres: Vec) -> Vec:
        return scale(subtract(metres, self.centre), self.scale)

    def vector(self, metres: Vec) -> Vec:
        return scale(metres, self.scale)

    def length(self, metres: float) -> float:
        return metres * self.scale


def normalise(world: World, refusals: Refusals, gather_radius_m: float = 0.0) -> Normalisation:
    """The normalisation of a world; raises NotTranslatable where no scale holds its smallest and its largest part.

    ``gather_radius_m`` is that of the photons, or 0 without them.
    """
    meshes = [solid.vertex_bounds for solid in world.solids if isinstance(solid, PlacedMesh)]
    bounds = together([world.extent, *meshes])
    diameter = 2 * bounds.radius_m
    least = min(features_of(world), default=None, key=lambda each: each.needs_m)
    smallest = diameter if least is None else least.needs_m
    factor = _power_of_two_below(LARGEST_EXTENT / diameter)
    while factor * diameter > SMALLEST_EXTENT and _bent_share(world, gather_radius_m, factor) > BENT_SHARE:
        factor /= 2
    while smallest * factor < SMALLEST_FEATURE and diameter * factor * 2 <= WIDEST_EXTENT:
        factor *= 2
    if least is not None and smallest * factor < SMALLEST_FEATURE:
        raise NotTranslatable([least.refused(refusals, diameter, factor)])
    centre = _centre(bounds.centre, diameter)
    result = Normalisation(centre, factor, diameter * factor)
    if length(result.point(world.scene.camera.position)) > FARTHEST_CAMERA:
        away = length(subtract(world.scene.camera.position, bounds.centre))
        what = f"the camera is {away:.3g} m away from a scene of {diameter:.3g} m"
        raise NotTranslatable([refusals.at(what, "move it nearer; POV-Ray loses digits there", "camera", "position")])
    return result


def in_metres(world: World, units: Normalisation) -> Normalisation:
    """The author's metres wherever POV-Ray's tolerances resolve the scene in them; else ``units``.

    Walls of meshes are not looked at, so a scene with meshes keeps its units.
    """
    extent_m = units.extent / units.scale
    smallest = min((each.needs_m for each in features_of(world)), default=extent_m)
    has_meshes = any(isinstance(solid, PlacedMesh) for solid in world.solids)
    is_resolved = smallest >= SMALLEST_FEATURE and SMALLEST_IN_METRES <= extent_m <= WIDEST_EXTENT
    if has_meshes or not is_resolved or length(units.centre) > 0:
        return units
    return Normalisation((0.0, 0.0, 0.0), 1.0, extent_m)


def _bent_share(world: World, gather_radius_m: float, factor: float) -> float:
    """What the most curved receiver of photons loses at a scale."""
    radii = [radius for _, radius in curved_receivers(world)]
    return max((lost_share(gather_radius_m * factor, radius * factor) for radius in radii), default=0.0)


def _power_of_two_below(value: float) -> float:
    return 2.0 ** math.floor(math.log2(value))


def _centre(centre: Vec, diameter: float) -> Vec:
    """Leave a scene that holds the origin where it is; otherwise move it by a round multiple of its size."""
    if length(centre) <= diameter:
        return (0.0, 0.0, 0.0)
    step = _power_of_two_below(diameter)
    x, y, z = (round(value / step) * step for value in centre)
    return (x, y, z)
