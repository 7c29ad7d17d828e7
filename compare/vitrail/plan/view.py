"""What the camera can see, by bounds, and how large a pixel is out there."""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.vector import Vec, add, cross, dot, length, scale, subtract, unit
from vitrail.geometry.bounds import Bounds
from vitrail.scene.model import Camera, Image, Plane

EDGE = 1e-9
"""Things that touch the edge of the picture count as seen; relative to the distances compared."""


@dataclass(frozen=True)
class View:
    """A camera with its orthonormal axes and the half size of the picture.

    Perspective: ``half_width`` and ``half_height`` are tangents, at distance 1. Orthographic: metres.
    """

    perspective: bool
    position: Vec
    forward: Vec
    right: Vec
    up: Vec
    half_width: float
    half_height: float
    rows: int

    def may_see(self, bounds: Bounds) -> bool:
        """Whether a box may be in the picture: it is not wholly beyond one of the five faces of the view."""
        if not bounds.is_finite:
            return True
        local = [self._to_view(corner) for corner in bounds.corners]
        reach = max(length(point) for point in local) * EDGE
        faces = [
            [sign * point[axis] - half * (point[2] if self.perspective else 1.0) for point in local]
            for axis, half in ((0, self.half_width), (1, self.half_height))
            for sign in (1.0, -1.0)
        ]
        return max(point[2] for point in local) > -reach and all(min(face) < reach for face in faces)

    def may_see_plane(self, plane: Plane) -> bool:
        """Whether a ray of the picture meets an infinite plane; exact, as the extremes are at the four corners."""
        normal = unit(plane.normal)
        for sx in (-1.0, 1.0):
            for sy in (-1.0, 1.0):
                origin, direction = self.corner_ray(sx, sy)
                distance, approach = dot(normal, subtract(origin, plane.point)), dot(normal, direction)
                if distance * approach < 0 or distance == 0:
                    return True
        return False

    def corner_ray(self, sx: float, sy: float) -> tuple[Vec, Vec]:
        """Origin and direction (not of unit length) of the ray at sx, sy in [-1, 1] of the picture."""
        aside = add(scale(self.right, sx * self.half_width), scale(self.up, sy * self.half_height))
        if self.perspective:
            return self.position, add(self.forward, aside)
        return add(self.position, aside), self.forward

    def pixel_size_m(self, point: Vec) -> float:
        """Side of a pixel at the depth of ``point``, metres, on a surface that faces the camera."""
        height = 2 * self.half_height / self.rows
        return height * max(self.depth_m(point), 0.0) if self.perspective else height

    @property
    def pixel_angle(self) -> float:
        """Angle of a pixel in the middle of a perspective picture, radians."""
        return 2 * self.half_height / self.rows

    def depth_m(self, point: Vec) -> float:
        return dot(subtract(point, self.position), self.forward)

    def _to_view(self, point: Vec) -> Vec:
        away = subtract(point, self.position)
        return (dot(away, self.right), dot(away, self.up), dot(away, self.forward))


def view_of(camera: Camera, image: Image) -> View:
    """The camera's axes: right = forward x up, so that +x is right when looking along -z."""
    forward = unit(subtract(camera.look_at, camera.position))
    right = unit(cross(forward, camera.up))
    up = cross(right, forward)
    if camera.kind == "perspective":
        assert camera.fov_deg is not None
        half_height = math.tan(math.radians(camera.fov_deg) / 2)
    else:
        assert camera.height is not None
        half_height = camera.height / 2
    return View(
        perspective=camera.kind == "perspective",
        position=camera.position,
        forward=forward,
        right=right,
        up=up,
        half_width=half_height * image.width / image.height,
        half_height=half_height,
        rows=image.height,
    )


def plane_hits(view: View, plane: Plane) -> list[Vec]:
    """Where the four corner rays of the picture meet a plane, those that do."""
    normal, hits = unit(plane.normal), []
    for sx, sy in ((-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)):
        origin, direction = view.corner_ray(sx, sy)
        distance, approach = dot(normal, subtract(origin, plane.point)), dot(normal, direction)
        if distance * approach < 0:
            hits.append(subtract(origin, scale(direction, distance / approach)))
    return hits
