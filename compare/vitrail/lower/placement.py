"""The numbers that both back ends need about a scene as a whole: where its middle is and how large it is."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.plan.bounds import bounds_of, bounds_of_light, bounds_of_patch, extent_of
from vitrail.scene.model import Scene
from vitrail.scene.vector import Vec, length, subtract


@dataclass(frozen=True)
class Extent:
    """A sphere around the finite part of a scene, metres, and the radius of its smallest finite object."""

    centre: Vec
    radius_m: float
    smallest_m: float


def extent_of_scene(scene: Scene) -> Extent:
    """Objects, lamps and patches; a scene of planes alone is as large as the way from camera to viewed point."""
    whole = extent_of(scene)
    sizes = [bounds_of(item).radius_m for item in scene.objects]
    return Extent(whole.centre, whole.radius_m, min([size for size in sizes if size > 0] + [whole.radius_m]))


def farthest_m(scene: Scene) -> float:
    """The largest distance from the camera to anything finite, metres."""
    boxes = [bounds_of(item) for item in scene.objects]
    boxes += [bounds_of_light(light) for light in scene.lights]
    boxes += [bounds_of_patch(observation.patch) for observation in scene.observe]
    points = [corner for box in boxes if box.is_finite for corner in box.corners]
    return max(length(subtract(point, scene.camera.position)) for point in [*points, scene.camera.look_at])
