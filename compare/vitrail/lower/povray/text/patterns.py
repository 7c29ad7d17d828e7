"""One colour, or a checker, as a POV-Ray pigment.

POV-Ray's checker is solid: squares of one unit in all three directions. It is laid with its z along the normal and half
a cell below the surface, so that the surface cuts one layer of cells and its squares are those of
``geometry/surface.py``.
"""

from __future__ import annotations

from typing import assert_never

from vitrail.base.vector import Vec, scale, subtract, unit
from vitrail.geometry.surface import frame_of
from vitrail.lower.povray.text.sdl import Block, Statement, Value, block, listed, matrix, rgb, statement
from vitrail.lower.povray.text.surface import Surface
from vitrail.scene.model import Checker, Disc, Plane, Rectangle


def coloured(
    texture: tuple[float, float, float] | Checker,
    surface: Surface,
    factor: float | tuple[float, ...],
    *,
    light: bool,
    passing: tuple[Value, ...] = (),
) -> Block:
    """A pigment: the texture times ``factor``, as radiance (``light``) or as a share.

    ``passing`` says what its colours let through, as ``("transmit", 0.5)``.
    """
    factors = [surface.seen * each for each in ((factor,) * 3 if isinstance(factor, float) else factor)]

    def shown(colour: tuple[float, float, float]) -> Statement:
        seen = surface.exposure.light(colour) if light else surface.exposure.share(colour)
        return statement(rgb([value * each for value, each in zip(seen, factors, strict=True)]), *passing)

    match texture:
        case Checker():
            first, second = texture.checker.colors
            squares = statement("checker", listed(shown(first), shown(second)))
            return block("pigment", squares, _laid(texture.checker.size, surface))
        case tuple():
            return block("pigment", shown(texture))
        case _:
            assert_never(texture)


def _laid(size_m: float, surface: Surface) -> Statement:
    """The matrix that carries POV-Ray's unit cells to the squares of a flat shape."""
    origin, u, v, normal = _flat_frame(surface)
    size = surface.normalisation.length(size_m)
    start = subtract(surface.normalisation.point(origin), scale(normal, size / 2))
    return matrix((scale(u, size), scale(v, size), scale(normal, size)), start)


def _flat_frame(surface: Surface) -> tuple[Vec, Vec, Vec, Vec]:
    """Origin, u, v and normal of a flat shape in the world."""
    shape = surface.placed.shape
    match shape:
        case Plane():
            u, v = frame_of(shape.normal)
            return shape.point, u, v, unit(shape.normal)
        case Disc():
            u, v = frame_of(shape.normal)
            return shape.center, u, v, unit(shape.normal)
        case Rectangle():
            u, v = unit(shape.u), unit(shape.v)
            normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            return shape.center, u, v, normal
        case _:
            raise ValueError("a checker needs a plane, a rectangle or a disc; check refuses others")
