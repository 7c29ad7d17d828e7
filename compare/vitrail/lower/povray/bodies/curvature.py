"""Where POV-Ray's photon kernel bends away from a surface: its distance grows by 1 + 16 |n . delta|, in its own units.

On a ball of radius B photons at the distance r lie r^2 / 2 B off the tangent plane, so a disc of radius R only holds
those with (1 + 8 r^2 / B) r^2 < R^2 [P 2.3]. All lengths are in units, so a smaller scale loses less.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Plane, Prism, Rectangle, Scene, Shape, Sphere


def curved_receivers(scene: Scene) -> Iterator[tuple[int, float]]:
    """Index and smallest radius of curvature, metres, of each curved surface that scatters."""
    for index, item in enumerate(scene.objects):
        curved = _curvature_radius(item.shape)
        if curved is not None and scene.material_of(item).is_diffuse:
            yield index, curved


def lost_share(gather_radius: float, curvature_radius: float) -> float:
    """Largest share of a disc that the bend may cost; both lengths in units."""
    stretch = 8 * gather_radius**2 / curvature_radius
    return stretch / (1 + stretch)


def _curvature_radius(shape: Shape) -> float | None:
    """The smallest radius of curvature, metres; None for flat faces, and for meshes, where it is not known."""
    match shape:
        case Sphere():
            return shape.radius
        case Cylinder():
            return shape.radius
        case Cone():
            return max(shape.radius_from, shape.radius_to)
        case Lens():
            return min((abs(radius) for radius in (shape.radius_front, shape.radius_back) if radius), default=None)
        case Plane() | Rectangle() | Disc() | Box() | Prism() | Mesh():
            return None
        case _:
            assert_never(shape)
