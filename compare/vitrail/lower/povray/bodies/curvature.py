"""Where POV-Ray's photon kernel bends away from a surface: its distance grows by 1 + 16 |n . delta|, in its own units.

On a ball of radius B photons at the distance r lie r^2 / 2 B off the tangent plane, so a disc of radius R only holds
those with (1 + 8 r^2 / B) r^2 < R^2 [P 2.3]. All lengths are in units, so a smaller scale loses less.
"""

from __future__ import annotations

from collections.abc import Iterator

from vitrail.geometry.world import World


def curved_receivers(world: World) -> Iterator[tuple[int, float]]:
    """Index and smallest radius of curvature, metres, of each curved surface that scatters."""
    for index, solid in enumerate(world.solids):
        curved = solid.curvature_radius_m
        if curved is not None and world.material(index).is_diffuse:
            yield index, curved


def lost_share(gather_radius: float, curvature_radius: float) -> float:
    """Largest share of a disc that the bend may cost; both lengths in units."""
    stretch = 8 * gather_radius**2 / curvature_radius
    return stretch / (1 + stretch)
