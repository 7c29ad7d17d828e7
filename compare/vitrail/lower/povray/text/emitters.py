"""Where the small lights stand that together make one with a surface or a solid angle.

Each stands at random within its own cell of equal size, so that the sum over all of them is unbiased. The second half
image has them on the other side of their cells: what varies evenly over a cell cancels in the mean of the two.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from random import Random

from vitrail.base.vector import Vec, add, cross, length, scale, unit
from vitrail.geometry.surface import tangents
from vitrail.scene.model import Disc, Rectangle

SMALL_SUN_DEG = 2.0
"""Diameter below which a penumbra is narrow and half of the small lights is enough."""


SKY_SHARE = 4
"""Directions of a sky for each small light of a lamp."""


@dataclass(frozen=True)
class Emitter:
    """One small light: where it is, which way it shines, and its share of the whole."""

    position: Vec
    direction: Vec
    share: float


@dataclass(frozen=True)
class Grid:
    """How many small lights, from which seed; ``is_mirrored`` puts each on the other side of its cell."""

    count: int
    seed: int
    is_mirrored: bool = False

    def places(self) -> Iterator[float]:
        """Random places in [0, 1), one a coordinate of a cell."""
        random = Random(self.seed)
        while True:
            place = random.random()
            yield 1 - place if self.is_mirrored else place


def rectangle_points(shape: Rectangle, grid: Grid) -> list[Emitter]:
    """Points on a rectangle, cells as nearly square as their number allows."""
    columns, rows = _columns_and_rows(grid.count, length(shape.u) / length(shape.v))
    normal = unit(cross(shape.u, shape.v))
    return [
        Emitter(
            add(shape.center, add(scale(shape.u, 2 * a - 1), scale(shape.v, 2 * b - 1))), normal, 1 / (columns * rows)
        )
        for a, b in _cells(columns, rows, grid)
    ]


def disc_points(shape: Disc, grid: Grid) -> list[Emitter]:
    """Points on a disc, in cells of equal area."""
    u, v = tangents(shape.normal)
    found = []
    for x, y, share in _disc_cells(grid):
        offset = add(scale(u, shape.radius * x), scale(v, shape.radius * y))
        found.append(Emitter(add(shape.center, offset), unit(shape.normal), share))
    return found


def sun_directions(direction: Vec, diameter_deg: float, grid: Grid) -> list[Emitter]:
    """Directions within the sun's disc, equal solid angles.

    A facing surface gets the share times the cosine towards the sun's rim, at most 4e-5 less for the real sun; the
    shares are raised so that their sum on a surface that faces the middle is 1.
    """
    u, v = tangents(direction)
    reach = math.radians(diameter_deg) / 2
    if diameter_deg < SMALL_SUN_DEG:
        grid = replace(grid, count=max(1, grid.count // 2))
    found = []
    for x, y, share in _disc_cells(grid):
        # Map the disc to the cap with equal areas: 1 - cos(angle) grows with the square of the radius.
        cosine = 1 - (1 - math.cos(reach)) * (x * x + y * y)
        sine, radius = math.sqrt(max(0.0, 1 - cosine * cosine)), math.hypot(x, y)
        aside = add(scale(u, x / radius), scale(v, y / radius)) if radius > 0 else (0.0, 0.0, 0.0)
        found.append((unit(add(scale(direction, cosine), scale(aside, sine))), share, cosine))
    facing = math.fsum(share * cosine for _, share, cosine in found)
    return [Emitter((0.0, 0.0, 0.0), way, share / facing) for way, share, _ in found]


def sphere_directions(grid: Grid) -> list[Emitter]:
    """Directions over the whole sphere, equal solid angles; many, because half of them are behind every surface."""
    cells = list(sphere_cells(grid))
    found = []
    for a, b in cells:
        z, turn = 1 - 2 * b, 2 * math.pi * a
        ring = math.sqrt(max(0.0, 1 - z * z))
        way = (ring * math.cos(turn), z, ring * math.sin(turn))
        found.append(Emitter((0.0, 0.0, 0.0), way, 1 / len(cells)))
    return found


def sphere_cells(grid: Grid) -> Iterator[tuple[float, float]]:
    """A point in each cell of the unit square that a whole sphere is mapped to: around, and from pole to pole."""
    columns, rows = _columns_and_rows(SKY_SHARE * grid.count, math.pi)
    return _cells(columns, rows, grid)


def _disc_cells(grid: Grid) -> Iterator[tuple[float, float, float]]:
    """(x, y, share) in the unit disc: rings of 3, 9, 15, ... cells, all of equal area."""
    rings = max(1, round(math.sqrt(grid.count / 3)))
    places = grid.places()
    turned = Random(grid.seed)
    per_ring = [3 * (2 * ring + 1) for ring in range(rings)]
    total, inner = sum(per_ring), 0
    for cells in per_ring:
        start = turned.random()
        for cell in range(cells):
            radius = math.sqrt((inner + cells * next(places)) / total)
            turn = 2 * math.pi * (cell + next(places) + start) / cells
            yield radius * math.cos(turn), radius * math.sin(turn), 1 / total
        inner += cells


def _cells(columns: int, rows: int, grid: Grid) -> Iterator[tuple[float, float]]:
    """A point in each cell of the unit square."""
    places = grid.places()
    for row in range(rows):
        for column in range(columns):
            yield (column + next(places)) / columns, (row + next(places)) / rows


def _columns_and_rows(count: int, aspect: float) -> tuple[int, int]:
    """About ``count`` cells that are about square in a shape of this aspect."""
    columns = max(1, round(math.sqrt(count * aspect)))
    return columns, max(1, round(count / columns))
