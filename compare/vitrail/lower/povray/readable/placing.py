"""Turned and moved shapes as their author wrote them: ``rotate`` and ``translate`` in the place of one matrix.

POV-Ray's ``rotate <x, y, z>`` turns about the world's x, then y, then z axis, by the formulas of the scene language.
"""

from __future__ import annotations

from vitrail.base.vector import Vec
from vitrail.geometry.frame import frame_of
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.edit import Edit
from vitrail.lower.povray.text.sdl import Block, Part, Statement, matrix, statement, vector
from vitrail.scene.model import Object

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
NOWHERE: Vec = (0.0, 0.0, 0.0)


def as_written(item: Object, units: Normalisation) -> Edit:
    """Put an object's own rotation and translation in the place of the matrix that stands for both."""
    frame = frame_of(item)
    x, y, z = zip(*frame.rotation, strict=True)
    origin = units.point(frame.origin)
    placed: list[Statement] = []
    if any(item.rotate_deg):
        placed.append(statement("rotate", vector(item.rotate_deg)))
    if any(origin):
        placed.append(statement("translate", vector(origin)))
    # POV-Ray sweeps a prism along y; exchange y and z first.
    upright = matrix((X, Z, Y), NOWHERE)
    written = {matrix((x, y, z), origin): tuple(placed), matrix((x, z, y), origin): (upright, *placed)}

    def edit(part: Part) -> Part:
        if not isinstance(part, Block):
            return part
        parts = tuple(each for inner in part.parts for each in _replaced(inner, written))
        return part if parts == part.parts else Block(part.head, parts)

    return edit


def _replaced(part: Part, written: dict[Statement, tuple[Statement, ...]]) -> tuple[Part, ...]:
    if isinstance(part, Statement) and part.keyword == "matrix":
        return written.get(part, (part,))
    return (part,)
