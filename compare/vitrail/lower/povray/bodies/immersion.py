"""What stands inside glass, and how much brighter its radiance is there than the camera may see it.

Radiance inside a medium of index n is n^2 times that outside, because refraction gathers light into a smaller cone.
POV-Ray copies radiance through a face unchanged [P 3.1], which is right for everything that light merely crosses, and
n^2 too bright for a surface that scatters or glows inside. Its own radiance is divided by that factor instead.
"""

from __future__ import annotations

import numpy as np

from vitrail.base.vector import Vec
from vitrail.geometry.inside import is_inside, is_solid
from vitrail.geometry.placement import place
from vitrail.geometry.surface_points import surface_points
from vitrail.optics.dispersion import reference_ior
from vitrail.scene.model import Object, Scene


def index_at_camera(scene: Scene) -> float:
    """The index of what the camera stands in."""
    return _index_around(scene, [scene.camera.position], but=None)


def index_around(scene: Scene, item: Object) -> float:
    """The index of the glass that holds a whole object, or 1."""
    placed = place(item)
    points = surface_points(placed, placed)
    return _index_around(scene, points, but=item) if points else 1.0


def seen_from_outside(scene: Scene, index: float) -> float:
    """What the camera sees of a radiance in a medium of ``index``."""
    return (index_at_camera(scene) / index) ** 2


def _index_around(scene: Scene, points: list[Vec], but: Object | None) -> float:
    """The index of the ruling glass among those that hold all points; among equals the first."""
    ruling: Object | None = None
    for item in scene.objects:
        if item is but or not is_solid(item) or not scene.material_of(item).is_transmissive:
            continue
        holds = bool(is_inside(item, np.array(points, float)).all())
        if holds and (ruling is None or (item.priority or 0) > (ruling.priority or 0)):
            ruling = item
    return reference_ior(scene.material_of(ruling)) if ruling is not None else 1.0
