"""Observed patches as places: their room, their corners, their normal."""

from __future__ import annotations

import itertools
from collections.abc import Iterable

from vitrail.base.vector import Vec
from vitrail.geometry.bounds import Bounds, about_parallelogram
from vitrail.scene.model import Patch


def bounds_of_patch(patch: Patch) -> Bounds:
    return about_parallelogram(patch.center, patch.u, patch.v)


def corners_of(patch: Patch) -> list[Vec]:
    """The four corners of a patch."""
    return _corners(patch, itertools.product((-1, 1), (-1, 1)))


def corners_around(patch: Patch) -> list[Vec]:
    """The four corners of a patch, each beside the one before it."""
    return _corners(patch, ((-1, -1), (1, -1), (1, 1), (-1, 1)))


def _corners(patch: Patch, signs: Iterable[tuple[int, int]]) -> list[Vec]:
    return [
        (
            patch.center[0] + a * patch.u[0] + b * patch.v[0],
            patch.center[1] + a * patch.u[1] + b * patch.v[1],
            patch.center[2] + a * patch.u[2] + b * patch.v[2],
        )
        for a, b in signs
    ]
