"""One colour, or a checker, as a POV-Ray pigment.

POV-Ray's checker is solid: squares of one unit in all three directions. It is laid with its z along the normal and half
a cell below the surface, so that the surface cuts one layer of cells and its squares are those of
``geometry/surface.py``.
"""

from __future__ import annotations

from typing import assert_never

from vitrail.base.vector import scale, subtract
from vitrail.lower.povray.text.sdl import Block, Statement, Value, block, listed, matrix, rgb, statement
from vitrail.lower.povray.text.surface import Surface
from vitrail.scene.model import Checker


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
    frame = surface.placed.surface_frame
    if frame is None:
        raise ValueError("a checker needs a plane, a rectangle or a disc; check refuses others")
    size = surface.normalisation.length(size_m)
    start = subtract(surface.normalisation.point(frame.origin), scale(frame.normal, size / 2))
    return matrix((scale(frame.u, size), scale(frame.v, size), scale(frame.normal, size)), start)
