"""The camera and the size of its picture as one projection, the same in both engines and in every measurement."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from vitrail.base.vector import Vec, add, cross, dot, scale, subtract, unit
from vitrail.scene.model import Camera, Image, Orthographic, Perspective

if TYPE_CHECKING:
    import numpy as np


@dataclass(frozen=True)
class Sighting:
    """Picture coordinates in [-1, 1] (x to the right, y up) and the depth along the view, metres."""

    x: float
    y: float
    depth_m: float

    @property
    def is_inside(self) -> bool:
        return self.depth_m > 0 and abs(self.x) <= 1 and abs(self.y) <= 1


@dataclass(frozen=True)
class View:
    """A camera with its orthonormal axes, and the half size of the picture.

    ``right = forward x up``, so that +x is right when looking along -z. ``half_width`` and ``half_height`` are tangents
    for a perspective camera, that is sizes at distance 1, and metres for an orthographic one. ``width`` and ``height``
    count pixels.
    """

    perspective: bool
    position: Vec
    forward: Vec
    right: Vec
    up: Vec
    half_width: float
    half_height: float
    width: int
    height: int

    @classmethod
    def of(cls, camera: Camera, image: Image) -> View:
        forward = unit(subtract(camera.look_at, camera.position))
        right = unit(cross(forward, camera.up))
        match camera.projection:
            case Perspective(fov_deg):
                half_height = math.tan(math.radians(fov_deg) / 2)
            case Orthographic(height):
                half_height = height / 2
        return cls(
            perspective=isinstance(camera.projection, Perspective),
            position=camera.position,
            forward=forward,
            right=right,
            up=cross(right, forward),
            half_width=half_height * image.width / image.height,
            half_height=half_height,
            width=image.width,
            height=image.height,
        )

    def ray(self, sx: float, sy: float) -> tuple[Vec, Vec]:
        """Origin and direction (not of unit length) of the ray at sx, sy in [-1, 1] of the picture, y up."""
        aside = add(scale(self.right, sx * self.half_width), scale(self.up, sy * self.half_height))
        if self.perspective:
            return self.position, add(self.forward, aside)
        return add(self.position, aside), self.forward

    def to_view(self, point: Vec) -> Vec:
        """Metres to the right of the camera, above it and ahead of it."""
        away = subtract(point, self.position)
        return (dot(away, self.right), dot(away, self.up), dot(away, self.forward))

    def depth_m(self, point: Vec) -> float:
        return dot(subtract(point, self.position), self.forward)

    def direction_to(self, point: Vec) -> Vec:
        """From the camera (its picture plane, if orthographic) to a point, metres."""
        return subtract(point, self.position) if self.perspective else scale(self.forward, self.depth_m(point))

    def sight_line(self, point: Vec) -> Vec:
        """The unit direction in which the camera looks at a point."""
        return unit(subtract(point, self.position)) if self.perspective else self.forward

    def sight(self, point: Vec) -> Sighting:
        """Where the picture shows a world point; behind a perspective camera x and y are infinite."""
        right, up, depth = self.to_view(point)
        if self.perspective and depth <= 0:
            return Sighting(math.inf, math.inf, depth)
        far = depth if self.perspective else 1.0
        return Sighting(right / (far * self.half_width), up / (far * self.half_height), depth)

    def pixel_size_m(self, point: Vec) -> float:
        """Side of a pixel at the depth of ``point``, metres, on a surface that faces the camera."""
        height = 2 * self.half_height / self.height
        return height * max(self.depth_m(point), 0.0) if self.perspective else height

    @property
    def pixel_angle(self) -> float:
        """Angle of a pixel in the middle of a perspective picture, radians."""
        return 2 * self.half_height / self.height

    # --- many points at once ----------------------------------------------------------------------------------------

    def project(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Pixel coordinates (x to the right, y down, the first pixel covers [0, 1]) and depth of ``points`` (..., 3).

        A point behind a perspective camera has depth <= 0 and NaN coordinates.
        """
        import numpy as np

        offset = np.asarray(points, float) - self.position
        depth = offset @ np.asarray(self.forward)
        far = np.where(depth > 0, depth, np.nan) if self.perspective else np.ones_like(depth)
        x = (offset @ np.asarray(self.right) / (far * self.half_width) + 1) * self.width / 2
        y = (1 - offset @ np.asarray(self.up) / (far * self.half_height)) * self.height / 2
        return x, y, depth

    def point_on_plane(self, x: float, y: float, plane_point: np.ndarray, normal: np.ndarray) -> np.ndarray:
        """The point of a plane that pixel coordinates (x, y) show."""
        import numpy as np

        origin, direction = self.ray(2 * x / self.width - 1, 1 - 2 * y / self.height)
        distance = np.dot(plane_point - np.asarray(origin), normal) / np.dot(direction, normal)
        return np.asarray(origin) + np.asarray(direction) * distance
