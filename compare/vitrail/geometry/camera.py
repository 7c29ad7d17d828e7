"""Where the camera sees a point, for checks on the scene alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.vector import Vec, cross, dot, subtract, unit
from vitrail.scene.model import Camera, Image


@dataclass(frozen=True)
class Sighting:
    """Picture coordinates in [-1, 1] (x to the right, y up) and the depth along the view, metres."""

    x: float
    y: float
    depth_m: float

    @property
    def is_inside(self) -> bool:
        return self.depth_m > 0 and abs(self.x) <= 1 and abs(self.y) <= 1


def sight(camera: Camera, image: Image, point: Vec) -> Sighting:
    """Project a world point; behind a perspective camera x and y are infinite."""
    forward = unit(subtract(camera.look_at, camera.position))
    right = unit(cross(forward, camera.up))
    up = cross(right, forward)
    away = subtract(point, camera.position)
    depth = dot(away, forward)
    if camera.kind == "orthographic":
        assert camera.height is not None
        half = camera.height / 2
    else:
        assert camera.fov_deg is not None
        if depth <= 0:
            return Sighting(math.inf, math.inf, depth)
        half = depth * math.tan(math.radians(camera.fov_deg) / 2)
    return Sighting(dot(away, right) / (half * image.width / image.height), dot(away, up) / half, depth)
