"""Where the small lights stand that together make one with a surface or a solid angle.

They are a Fibonacci lattice on the unit square, mapped to the light with equal areas: n points have n places along
either axis. A random shift moves it as a whole, so that the sum over all is unbiased; the second half image has a shift
of its own, and half the difference of the halves is the error of their mean. The lattice is folded like a tent where
the square does not close on itself: the error of what varies smoothly then falls as 1/n^2.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from random import Random

from vitrail.base.vector import Vec, add, cross, scale, unit
from vitrail.geometry.surface import tangents
from vitrail.scene.model import Disc, Rectangle

SMALL_SUN_DEG = 2.0
"""Diameter below which a penumbra is narrow and half of the small lights is enough."""


SKY_SHARE = 4
"""Directions of a sky over ``count``."""


@dataclass(frozen=True)
class Emitter:
    """One small light: where it is, which way it shines, and its share of the whole."""

    position: Vec
    direction: Vec
    share: float


@dataclass(frozen=True)
class Grid:
    """About how many small lights, from which seed; ``is_second`` are those of the second half image."""

    count: int
    seed: int
    is_second: bool = False

    def times(self, factor: float) -> Grid:
        """The same with another number."""
        return replace(self, count=max(round(factor * self.count), 1))

    def points(self) -> Iterator[tuple[float, float]]:
        """The shifted lattice, in [0, 1) x [0, 1); its size is the Fibonacci number that is nearest to ``count``."""
        step, size = 1, 1
        while size * (step + size) <= self.count**2:
            step, size = size, step + size
        random = Random(self.seed)
        shifts = [(random.random(), random.random()) for _ in range(2)]
        right, up = shifts[self.is_second]
        for index in range(size):
            yield (index / size + right) % 1, (index * step % size / size + up) % 1


def rectangle_points(shape: Rectangle, grid: Grid) -> list[Emitter]:
    """Points on a rectangle."""
    normal, points = unit(cross(shape.u, shape.v)), list(grid.points())
    return [
        Emitter(
            add(shape.center, add(scale(shape.u, 2 * _folded(a) - 1), scale(shape.v, 2 * _folded(b) - 1))),
            normal,
            1 / len(points),
        )
        for a, b in points
    ]


def disc_points(shape: Disc, grid: Grid) -> list[Emitter]:
    """Points on a disc, equal areas."""
    u, v = tangents(shape.normal)
    found = []
    for x, y, share in _disc_places(grid):
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
        grid = grid.times(0.5)
    found = []
    for x, y, share in _disc_places(grid):
        # Map the disc to the cap with equal areas: 1 - cos(angle) grows with the square of the radius.
        cosine = 1 - (1 - math.cos(reach)) * (x * x + y * y)
        sine, radius = math.sqrt(max(0.0, 1 - cosine * cosine)), math.hypot(x, y)
        aside = add(scale(u, x / radius), scale(v, y / radius)) if radius > 0 else (0.0, 0.0, 0.0)
        found.append((unit(add(scale(direction, cosine), scale(aside, sine))), share, cosine))
    facing = math.fsum(share * cosine for _, share, cosine in found)
    return [Emitter((0.0, 0.0, 0.0), way, share / facing) for way, share, _ in found]


def sphere_directions(grid: Grid) -> list[Emitter]:
    """Directions over the whole sphere, equal solid angles; many, because half of them are behind every surface."""
    places = list(sphere_places(grid))
    found = []
    for a, b in places:
        z, turn = 1 - 2 * b, 2 * math.pi * a
        ring = math.sqrt(max(0.0, 1 - z * z))
        way = (ring * math.cos(turn), z, ring * math.sin(turn))
        found.append(Emitter((0.0, 0.0, 0.0), way, 1 / len(places)))
    return found


def sphere_places(grid: Grid) -> Iterator[tuple[float, float]]:
    """Points of the unit square that a whole sphere is mapped to: around, and from pole to pole."""
    for a, b in grid.times(SKY_SHARE).points():
        yield a, _folded(b)


def _disc_places(grid: Grid) -> Iterator[tuple[float, float, float]]:
    """(x, y, share) in the unit disc: the square of the radius from the middle to the rim, and the angle around."""
    points = list(grid.points())
    for a, b in points:
        radius, turn = math.sqrt(_folded(a)), 2 * math.pi * b
        yield radius * math.cos(turn), radius * math.sin(turn), 1 / len(points)


def _folded(place: float) -> float:
    """A place in [0, 1), there and back: both ends of the lattice meet, whatever varies between them."""
    return 1 - abs(2 * place - 1)
