"""Whether light meets one pane of glass alone: parallel light, and panes beside each other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from vitrail.base.vector import Vec
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.shapes.box import PlacedBox
from vitrail.geometry.world import World
from vitrail.lower.povray.text.lights import Source
from vitrail.scene.model import Material


def is_one_pane_deep(world: World, lights: Sequence[Source]) -> bool:
    """Whether each photon leaves one face of one pane and comes to no other glass or mirror.

    Proven for parallel lights and specular boxes that mirror nothing, bend and dim nothing by angle, and whose shadows
    along the light are apart. Light through two faces of a box at a right angle is not counted.
    """
    specular = [index for index in range(len(world.solids)) if world.material(index).is_specular]
    if not all(isinstance(world.solids[index], PlacedBox) and _is_plain(world.material(index)) for index in specular):
        return False
    rooms = [world.solids[index].bounds for index in specular]
    return all(
        source.direction is not None
        and all(_are_apart(source.direction, first, second) for first, second in combinations(rooms, 2))
        for source in lights
    )


def _is_plain(material: Material) -> bool:
    """Faces that all pass the same share of light."""
    varies = material.fresnel or material.attenuation is not None or material.absorption_per_m is not None
    return max(material.reflection) == 0 and not material.roughness and not varies


def _are_apart(direction: Vec, first: Bounds, second: Bounds) -> bool:
    """Whether no line along a direction meets the boxes around both: some axis across it separates their shadows."""
    way = np.asarray(direction, float)
    corners = [np.asarray(each.corners, float) for each in (first, second)]
    # Shadows of boxes are convex; the sides of both are shadows of edges, which lie along the axes.
    for axis in np.cross(way, np.eye(3)):
        if not np.any(axis):
            continue
        one, other = (each @ axis for each in corners)
        if one.max() <= other.min() or other.max() <= one.min():
            return True
    return False
