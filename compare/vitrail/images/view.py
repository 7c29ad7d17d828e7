"""Where the camera of a scene sees a point of the world, in pixels. The same geometry as both engines."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from vitrail.scene.model import Camera, Image


def _unit(vector: np.ndarray) -> np.ndarray:
    return vector / np.linalg.norm(vector)


@dataclass(frozen=True)
class View:
    """A camera and an image size as one projection.

    ``forward``, ``right = forward x up`` and ``up`` are orthonormal. ``half_width`` and ``half_height`` are tangents
    for a perspective camera, metres for an orthographic one.
    """

    perspective: bool
    position: np.ndarray
    forward: np.ndarray
    right: np.ndarray
    up: np.ndarray
    half_width: float
    half_height: float
    width: int
    height: int

    @classmethod
    def of(cls, camera: Camera, image: Image) -> View:
        forward = _unit(np.subtract(camera.look_at, camera.position))
        right = _unit(np.cross(forward, camera.up))
        perspective = camera.kind == "perspective"
        if perspective:
            assert camera.fov_deg is not None
            half_height = math.tan(math.radians(camera.fov_deg) / 2)
        else:
            assert camera.height is not None
            half_height = camera.height / 2
        aspect = image.width / image.height
        position = np.asarray(camera.position, float)
        up = np.cross(right, forward)
        return cls(
            perspective, position, forward, right, up, half_height * aspect, half_height, image.width, image.height
        )

    def project(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Pixel coordinates (x to the right, y down, the first pixel covers [0, 1]) and depth of ``points`` (..., 3).

        A point behind a perspective camera has depth <= 0 and NaN coordinates.
        """
        offset = np.asarray(points, float) - self.position
        depth = offset @ self.forward
        scale = np.where(depth > 0, depth, np.nan) if self.perspective else np.ones_like(depth)
        x = (offset @ self.right / (scale * self.half_width) + 1) * self.width / 2
        y = (1 - offset @ self.up / (scale * self.half_height)) * self.height / 2
        return x, y, depth

    def point_on_plane(self, x: float, y: float, plane_point: np.ndarray, normal: np.ndarray) -> np.ndarray:
        """The point of a plane that pixel coordinates (x, y) show."""
        sx, sy = 2 * x / self.width - 1, 1 - 2 * y / self.height
        across = sx * self.half_width * self.right + sy * self.half_height * self.up
        origin = self.position if self.perspective else self.position + across
        direction = self.forward + across if self.perspective else self.forward
        return origin + direction * (np.dot(plane_point - origin, normal) / np.dot(direction, normal))
