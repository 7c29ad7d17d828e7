"""What stands inside glass, and how much brighter its radiance is there than the camera may see it.

Radiance inside a medium of index n is n^2 times that outside, because refraction gathers light into a smaller cone.
POV-Ray copies radiance through a face unchanged [P 3.1], which is right for everything that light merely crosses, and
n^2 too bright for a surface that scatters or glows inside. Its own radiance is divided by that factor instead.
"""

from __future__ import annotations

import math

import numpy as np

from vitrail.base.vector import add, length, scale, subtract
from vitrail.geometry.shapes.flat import PlacedDisc, PlacedRectangle
from vitrail.geometry.surface import tangents
from vitrail.geometry.touch import TOUCH
from vitrail.geometry.world import World
from vitrail.optics.dispersion import reference_ior

GRID = 33
"""Points along a flat shape, edge to edge, where it is asked whether it stands in glass."""


def glass_at_camera(world: World) -> int | None:
    """The glass that the camera looks through first: one that stands on a face looks away from the glass behind it."""
    camera = world.scene.camera
    sight = subtract(camera.look_at, camera.position)
    ahead = TOUCH * max(1.0, length(camera.position) / length(sight))
    return world.medium_around([add(camera.position, scale(sight, ahead))], None)


def glass_around(world: World, index: int) -> int | None:
    """The glass that holds the whole object ``index``."""
    solid = world.solids[index]
    points = solid.surface_points(solid)
    return world.medium_around(points, index) if points else None


def index_around(world: World, index: int) -> float:
    """The refraction index of the glass that holds the whole object ``index``, or 1."""
    ruling = glass_around(world, index)
    return 1.0 if ruling is None else reference_ior(world.material(ruling))


def partly_around(world: World, index: int) -> tuple[int, ...]:
    """The glasses that a body which is none reaches into with a part of its surface, in the scene's order.

    What takes room from the body is none of them: its face is cut out there.
    """
    solid, found = world.solids[index], []
    points = solid.surface_points(solid)
    for glass, other in enumerate(world.solids):
        if glass == index or not other.is_closed or not world.material(glass).is_transmissive:
            continue
        is_whole = bool(points) and bool(other.is_inside(np.array(points, float)).all())
        if not is_whole and not world.displaces(glass, index) and _reach_into_each_other(world, index, glass):
            found.append(glass)
    return tuple(found)


def _reach_into_each_other(world: World, index: int, glass: int) -> bool:
    """Whether a part of a surface lies inside a glass; of a flat one by points on a grid."""
    solid, other = world.solids[index], world.solids[glass]
    (low, high), (other_low, other_high) = ((each.bounds.low, each.bounds.high) for each in (solid, other))
    if any(low[axis] > other_high[axis] or other_low[axis] > high[axis] for axis in range(3)):
        return False
    if solid.is_closed:
        return bool(world.overlap(index, glass))
    if not isinstance(solid, PlacedRectangle | PlacedDisc):
        return False
    slack = TOUCH * max(solid.number_size_m, other.number_size_m)
    return bool((other.depth(_grid(solid)) > slack).any())


def _grid(flat: PlacedRectangle | PlacedDisc) -> np.ndarray:
    """Points (n, 3) all over a flat shape."""
    along = np.linspace(-1, 1, GRID)
    a, b = (each.ravel()[:, None] for each in np.meshgrid(along, along))
    if isinstance(flat, PlacedRectangle):
        return np.asarray(flat.shape.center) + a * flat.shape.u + b * flat.shape.v
    u, v = tangents(flat.shape.normal)
    radius, turn = flat.shape.radius * (a + 1) / 2, math.pi * b
    return np.asarray(flat.shape.center) + radius * np.cos(turn) * u + radius * np.sin(turn) * v
