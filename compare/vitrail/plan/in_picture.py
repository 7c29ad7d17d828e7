"""What may be in the picture of a camera, by bounds."""

from __future__ import annotations

from vitrail.base.vector import Vec, dot, length, scale, subtract, unit
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.camera import View
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.solid import Solid
from vitrail.scene.model import Plane

EDGE = 1e-9
"""Things that touch the edge of the picture count as seen; relative to the distances compared."""
CORNERS = ((-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0))


def may_see(view: View, solid: Solid) -> bool:
    """Whether a solid may be in the picture; a plane exactly, everything else by the box around it."""
    if isinstance(solid, PlacedPlane):
        return sees_plane(view, solid.shape)
    return may_see_box(view, solid.bounds)


def may_see_box(view: View, bounds: Bounds) -> bool:
    """Whether a box may be in the picture: it is not wholly beyond one of the five faces of the view."""
    if not bounds.is_finite:
        return True
    local = [view.to_view(corner) for corner in bounds.corners]
    reach = max(length(point) for point in local) * EDGE
    faces = [
        [sign * point[axis] - half * (point[2] if view.perspective else 1.0) for point in local]
        for axis, half in ((0, view.half_width), (1, view.half_height))
        for sign in (1.0, -1.0)
    ]
    return max(point[2] for point in local) > -reach and all(min(face) < reach for face in faces)


def sees_plane(view: View, plane: Plane) -> bool:
    """Whether a ray of the picture meets an infinite plane; exact, as the extremes are at the four corners."""
    return any(distance * approach < 0 or distance == 0 for _, _, distance, approach in _corner_rays(view, plane))


def plane_hits(view: View, plane: Plane) -> list[Vec]:
    """Where the four corner rays of the picture meet a plane, those that do."""
    return [
        subtract(origin, scale(direction, distance / approach))
        for origin, direction, distance, approach in _corner_rays(view, plane)
        if distance * approach < 0
    ]


def _corner_rays(view: View, plane: Plane) -> list[tuple[Vec, Vec, float, float]]:
    """The rays of the four corners: origin, direction, height above a plane, and how fast the ray rises from it."""
    normal, found = unit(plane.normal), []
    for sx, sy in CORNERS:
        origin, direction = view.ray(sx, sy)
        found.append((origin, direction, dot(normal, subtract(origin, plane.point)), dot(normal, direction)))
    return found
