"""Bring a scene to the size that POV-Ray's absolute tolerances were made for, and back.

POV-Ray ignores hits nearer than 1e-4, shadows nearer than 1e-3 and everything beyond 1e7 units, and stores photon
positions in single precision [P 7]. A scene is moved to the origin where it lies far away, and multiplied by a power of
two, so that no digit is lost: lengths in the scene description are units = (metres - centre) * scale.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import assert_never

from vitrail.base.vector import Vec, length, scale, subtract
from vitrail.geometry.bounds import Bounds, extent_of, together
from vitrail.lower.povray.bodies.curvature import curved_receivers, lost_share
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Plane, Prism, Rectangle, Scene, Shape, Sphere

LARGEST_EXTENT = 64.0
"""Extent in units that a scene is brought to (at most, and more than half of it)."""
SMALLEST_EXTENT = 8.0
"""The same where photons fall on curved surfaces, if it must be: smaller, gaps and hairs become visible lengths."""
BENT_SHARE = 0.01
"""Share of a photon disc that a curved surface may lose before the scene is made smaller; an opal ball lost 23 %."""
SMALLEST_FEATURE = 0.01
"""Thickness in units that every tolerance of POV-Ray resolves by a factor of ten [P 7]."""
WIDEST_EXTENT = 8192.0
"""Extent in units up to which thin features may push the scale: single precision still places photons to 5e-4 units."""
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


def normalise(
    scene: Scene, meshes: Sequence[Bounds], refusals: Refusals, gather_radius_m: float = 0.0
) -> Normalisation:
    """The normalisation of a scene; raises NotTranslatable where no scale holds its smallest and its largest part.

    ``gather_radius_m`` is that of the photons, or 0 without them.
    """
    bounds = together([extent_of(scene), *meshes])
    diameter = 2 * bounds.radius_m
    smallest, thinnest = min(_features(scene), default=(diameter, None))
    factor = _power_of_two_below(LARGEST_EXTENT / diameter)
    while factor * diameter > SMALLEST_EXTENT and _bent_share(scene, gather_radius_m, factor) > BENT_SHARE:
        factor /= 2
    while smallest * factor < SMALLEST_FEATURE and diameter * factor * 2 <= WIDEST_EXTENT:
        factor *= 2
    if smallest * factor < SMALLEST_FEATURE and thinnest is not None:
        what = (
            f"a feature of {smallest:.3g} m in a scene of {diameter:.3g} m is {smallest * factor:.2g} POV-Ray units"
            f" thick, below the {SMALLEST_FEATURE:g} that its absolute tolerances resolve"
        )
        raise NotTranslatable([refusals.at(what, "make it thicker or the scene smaller", "objects", thinnest)])
    centre = _centre(bounds.centre, diameter)
    result = Normalisation(centre, factor, diameter * factor)
    if length(result.point(scene.camera.position)) > FARTHEST_CAMERA:
        away = length(subtract(scene.camera.position, bounds.centre))
        what = f"the camera is {away:.3g} m away from a scene of {diameter:.3g} m"
        raise NotTranslatable([refusals.at(what, "move it nearer; POV-Ray loses digits there", "camera", "position")])
    return result


def _bent_share(scene: Scene, gather_radius_m: float, factor: float) -> float:
    """What the most curved receiver of photons loses at a scale."""
    radii = [radius for _, radius in curved_receivers(scene)]
    return max((lost_share(gather_radius_m * factor, radius * factor) for radius in radii), default=0.0)


def _features(scene: Scene) -> Iterator[tuple[float, int]]:
    """The smallest thickness of each solid object, metres, with its index."""
    for index, item in enumerate(scene.objects):
        thickness = thickness_of(item.shape)
        if math.isfinite(thickness):
            yield thickness, index


def thickness_of(shape: Shape) -> float:
    """The smallest thickness of a solid, metres; infinite for what is flat, open or a mesh."""
    match shape:
        case Sphere():
            return 2 * shape.radius
        case Plane() | Rectangle() | Disc() | Mesh():
            return math.inf
        case Box():
            return min(high - low for low, high in zip(shape.min, shape.max, strict=True))
        case Cylinder():
            return min(2 * shape.radius, length(subtract(shape.to, shape.from_)))
        case Cone():
            return min(2 * max(shape.radius_from, shape.radius_to), length(subtract(shape.to, shape.from_)))
        case Prism():
            corners = shape.corners
            edges = zip(corners, corners[1:] + corners[:1], strict=True)
            return min(shape.height, *(math.dist(a, b) for a, b in edges))
        case Lens():
            return min(shape.thickness, shape.diameter)
        case _:
            assert_never(shape)


def _power_of_two_below(value: float) -> float:
    return 2.0 ** math.floor(math.log2(value))


def _centre(centre: Vec, diameter: float) -> Vec:
    """Leave a scene that holds the origin where it is; otherwise move it by a round multiple of its size."""
    if length(centre) <= diameter:
        return (0.0, 0.0, 0.0)
    step = _power_of_two_below(diameter)
    x, y, z = (round(value / step) * step for value in centre)
    return (x, y, z)
