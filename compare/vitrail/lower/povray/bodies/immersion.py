"""What stands inside glass, and how much brighter its radiance is there than the camera may see it.

Radiance inside a medium of index n is n^2 times that outside, because refraction gathers light into a smaller cone.
POV-Ray copies radiance through a face unchanged [P 3.1], which is right for everything that light merely crosses, and
n^2 too bright for a surface that scatters or glows inside. Its own radiance is divided by that factor instead.
"""

from __future__ import annotations

from vitrail.base.vector import Vec
from vitrail.geometry.world import World
from vitrail.optics.dispersion import reference_ior


def index_at_camera(world: World) -> float:
    """The index of what the camera stands in."""
    return _index_around(world, [world.scene.camera.position], but=None)


def index_around(world: World, index: int) -> float:
    """The refraction index of the glass that holds the whole object ``index``, or 1."""
    solid = world.solids[index]
    points = solid.surface_points(solid)
    return _index_around(world, points, but=index) if points else 1.0


def seen_from_outside(world: World, ior: float) -> float:
    """What the camera sees of a radiance in a medium of this refraction index."""
    return (index_at_camera(world) / ior) ** 2


def _index_around(world: World, points: list[Vec], but: int | None) -> float:
    ruling = world.medium_around(points, but)
    return 1.0 if ruling is None else reference_ior(world.material(ruling))
