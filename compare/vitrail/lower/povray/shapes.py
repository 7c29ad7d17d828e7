"""Shapes as POV-Ray objects, in units.

World-coordinate shapes are written with their numbers; shapes with own axes carry one ``matrix``. The texture is
added after the matrix, so patterns are always in world coordinates.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from vitrail.lower.povray.normalise import Normalisation
from vitrail.lower.povray.sdl import matrix, number, vector
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lens, Mesh, Plane, Prism, Rectangle, Sphere
from vitrail.scene.placement import Frame, Placed
from vitrail.scene.vector import Vec, add, dot, scale, unit


@dataclass(frozen=True)
class Primitive:
    """The keyword of a POV-Ray object and the parts that come before its texture."""

    keyword: str
    parts: tuple[str, ...]


def primitive(placed: Placed, normalisation: Normalisation) -> Primitive:
    """The POV-Ray object of a placed shape."""
    shape, units = placed.shape, normalisation
    match shape:
        case Sphere():
            return Primitive("sphere", (f"{vector(units.point(shape.center))}, {number(units.length(shape.radius))}",))
        case Plane():
            normal = unit(shape.normal)
            return Primitive("plane", (f"{vector(normal)}, {number(dot(normal, units.point(shape.point)))}",))
        case Rectangle():
            return _rectangle(shape, units)
        case Disc():
            centre = vector(units.point(shape.center))
            return Primitive("disc", (f"{centre}, {vector(unit(shape.normal))}, {number(units.length(shape.radius))}",))
        case Box():
            return Primitive("box", (_corners(shape, units), _frame(placed.frame, units)))
        case Cylinder():
            ends = f"{vector(units.point(shape.from_))}, {vector(units.point(shape.to))}"
            return Primitive("cylinder", (f"{ends}, {number(units.length(shape.radius))}",))
        case Cone():
            first = f"{vector(units.point(shape.from_))}, {number(units.length(shape.radius_from))}"
            last = f"{vector(units.point(shape.to))}, {number(units.length(shape.radius_to))}"
            return Primitive("cone", (f"{first}, {last}",))
        case Prism() | Lens() | Mesh():
            raise NotImplementedError(type(shape).__name__)
        case _:
            assert_never(shape)


def _rectangle(shape: Rectangle, units: Normalisation) -> Primitive:
    """A polygon: one flat primitive, so that no seam between two triangles can leak."""
    centre, u, v = units.point(shape.center), units.vector(shape.u), units.vector(shape.v)
    corners = [add(centre, add(scale(u, a), scale(v, b))) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
    return Primitive("polygon", ("5, " + ", ".join(vector(corner) for corner in corners),))


def _corners(shape: Box, units: Normalisation) -> str:
    return f"{vector(units.vector(shape.min))}, {vector(units.vector(shape.max))}"


def _frame(frame: Frame, units: Normalisation) -> str:
    """The frame as a matrix; nothing where the scene is neither turned nor moved."""
    origin = units.point(frame.origin)
    axes: tuple[Vec, Vec, Vec] = tuple(zip(*frame.rotation, strict=True))  # type: ignore[assignment]
    if axes == ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)) and origin == (0.0, 0.0, 0.0):
        return ""
    return matrix(axes, origin)
