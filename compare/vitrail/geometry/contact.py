"""Solids whose faces lie on each other: nothing is between them, not even air."""

from __future__ import annotations

import numpy as np

from vitrail.base.vector import Vec, length
from vitrail.geometry.solid import Solid
from vitrail.geometry.touch import TOUCH

AREA = 1e-3
"""Share of a contact's length that its width must have to be an area."""


def shared_points(a: Solid, b: Solid) -> list[Vec]:
    """Points of either surface that lie on the other one."""
    return [*_on(b, a.surface_points(b)), *_on(a, b.surface_points(a))]


def is_area(points: list[Vec]) -> bool:
    """Whether points spread over an area, and do not lie along a line or in one place."""
    if len(points) < 3:
        return False
    spread = np.linalg.svd(np.subtract(points, np.mean(points, axis=0)), compute_uv=False)
    return bool(spread[1] > AREA * spread[0])


def _on(solid: Solid, points: list[Vec]) -> list[Vec]:
    """The points that lie on the surface of a solid."""
    away = solid.distances(points)
    return [point for point, each in zip(points, away, strict=True) if each <= TOUCH * max(1.0, length(point))]
