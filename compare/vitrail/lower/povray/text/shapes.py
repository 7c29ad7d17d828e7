"""Shapes as POV-Ray objects, in units.

World-coordinate shapes are written with their numbers; shapes with own axes carry one ``matrix``. The texture is
added after the matrix, so patterns are always in world coordinates.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from vitrail.base.vector import Vec, add, dot, scale, unit
from vitrail.geometry.frame import Frame
from vitrail.geometry.placement import solid_of
from vitrail.geometry.shapes.lathe import PlacedLathe
from vitrail.geometry.shapes.lens import sagitta
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.solid import Solid
from vitrail.geometry.surface import tangents
from vitrail.lower.povray.bodies.meshes import mesh_parts
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.sdl import (
    Block,
    Listed,
    Part,
    Statement,
    block,
    listed,
    matrix,
    present,
    statement,
    vector,
)
from vitrail.scene.model import Box, Cone, Cylinder, Disc, Lathe, Lens, Mesh, Plane, Prism, Rectangle, Sphere, Torus

SWEEP_BEYOND_ENDS = 1 + 1 / 64
"""A prism's sweep over its height: so little that photons are aimed at next to nothing beside it."""


@dataclass(frozen=True)
class Primitive:
    """The keyword of a POV-Ray object and the parts that come before its texture."""

    keyword: str
    parts: tuple[Part, ...]

    @property
    def sdl(self) -> Block:
        """The object without a look of its own."""
        return Block(self.keyword, self.parts)


def primitive(placed: Solid, normalisation: Normalisation) -> Primitive:
    """The POV-Ray object of a placed shape."""
    shape, units = placed.shape, normalisation
    match shape:
        case Sphere():
            return Primitive("sphere", (listed(vector(units.point(shape.center)), units.length(shape.radius)),))
        case Plane():
            normal = unit(shape.normal)
            return Primitive("plane", (listed(vector(normal), dot(normal, units.point(shape.point))),))
        case Rectangle():
            return _rectangle(shape, units)
        case Disc():
            centre = vector(units.point(shape.center))
            return Primitive("disc", (listed(centre, vector(unit(shape.normal)), units.length(shape.radius)),))
        case Box():
            return Primitive("box", present((_corners(shape, units), _frame(placed.frame, units))))
        case Cylinder():
            ends = (vector(units.point(shape.from_)), vector(units.point(shape.to)))
            return Primitive("cylinder", (listed(*ends, units.length(shape.radius)),))
        case Cone():
            first = (vector(units.point(shape.from_)), units.length(shape.radius_from))
            last = (vector(units.point(shape.to)), units.length(shape.radius_to))
            return Primitive("cone", (listed(*first, *last),))
        case Prism():
            return _prism(shape, placed.frame, units)
        case Lens():
            return _lens(shape, placed.frame, units)
        case Torus():
            return _torus(shape, units)
        case Lathe():
            assert isinstance(placed, PlacedLathe)
            return _lathe(placed, units)
        case Mesh():
            assert isinstance(placed, PlacedMesh)
            return Primitive("mesh2", mesh_parts(placed, units))
        case _:
            assert_never(shape)


def _rectangle(shape: Rectangle, units: Normalisation) -> Primitive:
    """A polygon: one flat primitive, so that no seam between two triangles can leak."""
    centre, u, v = units.point(shape.center), units.vector(shape.u), units.vector(shape.v)
    corners = [add(centre, add(scale(u, a), scale(v, b))) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
    return Primitive("polygon", (listed(len(corners), *map(vector, corners)),))


def aperture(shape: Rectangle | Disc, units: Normalisation) -> Block:
    """The outline of a collimated lamp, as an object for light to pass through."""
    return primitive(solid_of(shape), units).sdl


def _prism(shape: Prism, frame: Frame, units: Normalisation) -> Primitive:
    """POV-Ray sweeps a profile of (x, z) along y; ours lies in x, y and is swept along z.

    POV-Ray takes the normal of both ends of its prism to point along the sweep, so that light enters one of them from
    what looks like its inside. The sweep is made longer, and the ends are those of a box.
    """
    half, corners = units.length(shape.height) / 2, [(units.length(x), units.length(y)) for x, y in shape.corners]
    outline = [vector(corner) for corner in (*corners, corners[0])]
    longer, wider = half * SWEEP_BEYOND_ENDS, 2 * max(max(map(abs, corner)) for corner in corners)
    sweep = block("prism", statement("linear_sweep", "linear_spline", listed(-longer, longer, len(outline), *outline)))
    ends = block("box", listed(vector((-wider, -half, -wider)), vector((wider, half, wider))))
    # Exchange y and z, then turn and move.
    x, y, z = _axes(frame)
    return Primitive("intersection", (sweep, ends, matrix((x, z, y), units.point(frame.origin))))


def _lens(shape: Lens, frame: Frame, units: Normalisation) -> Primitive:
    """A cylinder about z, cut by a ball for each curved face."""
    thickness, rim = units.length(shape.thickness), units.length(shape.diameter) / 2
    faces, ends = [], []
    for radius_m, side in ((shape.radius_front, -1.0), (shape.radius_back, 1.0)):
        vertex, radius = side * thickness / 2, units.length(radius_m)
        if radius > 0:
            faces.append(block("sphere", listed(vector((0, 0, vertex - side * radius)), radius)))
            ends.append(vertex + side * rim)
        elif radius < 0:
            ball = listed(vector((0, 0, vertex - side * radius)), -radius)
            faces.append(block("sphere", ball, statement("inverse")))
            ends.append(vertex - side * sagitta(radius, rim))
        else:
            ends.append(vertex)
    body = block("cylinder", listed(vector((0, 0, ends[0])), vector((0, 0, ends[1])), rim))
    return Primitive("intersection", present((body, *faces, _frame(frame, units))))


def _torus(shape: Torus, units: Normalisation) -> Primitive:
    """POV-Ray's torus lies about the origin and the y axis. Without `sturm` 2 of 9216 rays lost a root of
    a tube of 1/500 of its ring."""
    axis = unit(shape.normal)
    u, v = tangents(axis)
    radii = listed(units.length(shape.radius), units.length(shape.radius_tube))
    return Primitive("torus", (radii, statement("sturm"), matrix((u, axis, scale(v, -1)), units.point(shape.center))))


def _lathe(placed: PlacedLathe, units: Normalisation) -> Primitive:
    """The corners, and the first one again unless both ends lie on the axis, where no piece is missing.

    They go counter-clockwise: POV-Ray takes the side to their right for the outside.
    """
    corners = list(placed.corners)
    if corners[0][0] > 0 or corners[-1][0] > 0:
        corners.append(corners[0])
    points = [vector((units.length(radius), units.length(height))) for radius, height in corners]
    head = statement("linear_spline", listed(len(points), *points))
    return Primitive("lathe", present((head, _frame(placed.frame, units))))


def _axes(frame: Frame) -> tuple[Vec, Vec, Vec]:
    """Where the frame's x, y and z point in the world."""
    x, y, z = zip(*frame.rotation, strict=True)
    return x, y, z


def _corners(shape: Box, units: Normalisation) -> Listed:
    return listed(vector(units.vector(shape.min)), vector(units.vector(shape.max)))


def _frame(frame: Frame, units: Normalisation) -> Statement | None:
    """The frame as a matrix; None where the scene is neither turned nor moved."""
    origin = units.point(frame.origin)
    axes = _axes(frame)
    if axes == ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)) and origin == (0.0, 0.0, 0.0):
        return None
    return matrix(axes, origin)
