"""How far the surfaces of two solids are from each other."""

from __future__ import annotations

import math

from vitrail.geometry.solid import Solid


def surface_distance(a: Solid, b: Solid) -> float:
    """The least distance found between two surfaces, metres; infinite where it is not known."""
    from_a, from_b = b.distances(a.surface_points(b)), a.distances(b.surface_points(a))
    return min([*from_a, *from_b], default=math.inf)
