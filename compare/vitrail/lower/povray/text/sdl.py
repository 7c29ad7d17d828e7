"""POV-Ray's scene description language as a tree: values, statements and blocks, printed once by ``printer.py``.

The tree is the only door through which anything reaches a POV-Ray scene: numbers, fixed words and generated
identifiers. No name, title or path of a scene file ever becomes scene text [P 8.5]. The printer checks every number,
because POV-Ray reads ``1e400`` as infinity without a word [P 12.20], and every word, so that none can end a block or
begin a directive.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from vitrail.base.vector import Vec

# --- values ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Vector:
    """``<1, 2, 3>``, of any length."""

    numbers: tuple[float, ...]


@dataclass(frozen=True)
class Colour:
    """``rgb <1, 2, 3>``, linear; printed as one number where the channels are equal."""

    channels: tuple[float, float, float]


@dataclass(frozen=True)
class Product:
    """``90*y``: values multiplied."""

    factor: Value
    of: Value


@dataclass(frozen=True)
class Quotient:
    """``image_width/image_height``; what stands below has no operator of its own."""

    above: Value
    below: Value


@dataclass(frozen=True)
class Call:
    """``tan(radians(35)/2)``: a function of POV-Ray with its arguments."""

    function: str
    arguments: tuple[Value, ...]


@dataclass(frozen=True)
class Identifier:
    """``M_Clear``: a name that a file declares; it begins with a capital, as no word of the language does."""

    name: str


@dataclass(frozen=True)
class Quoted:
    """``"photons.map"``: the name of a file, made by this package."""

    text: str


@dataclass(frozen=True)
class Listed:
    """``<0, 1, 0>, 0.5``: values with commas between them."""

    values: tuple[Value, ...]


@dataclass(frozen=True)
class Statement:
    """``ior 1.5``: words and values with blanks between them; a keyword comes first where there is one."""

    values: tuple[Value, ...]

    @property
    def keyword(self) -> str:
        """The first word; empty where a statement begins with a value."""
        first = self.values[0]
        return first if isinstance(first, str) else ""


Value = float | str | Vector | Colour | Product | Quotient | Call | Identifier | Quoted | Listed | Statement
"""What stands within a statement; a string is a word of the language."""

# --- parts ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Block:
    """``head { parts }``."""

    head: str
    parts: tuple[Part, ...]


@dataclass(frozen=True)
class MapEntry:
    """``[0.5 pigment { rgb 1 }]``: one entry of a texture or normal map, at a place or with a weight."""

    at: float
    parts: tuple[Part, ...]


@dataclass(frozen=True)
class Table:
    """``face_indices { 2, <0, 1, 2>, <2, 3, 0> }``: many rows after their count, one a line."""

    head: str
    rows: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Directive:
    """``#version 3.7;``."""

    word: str
    value: Value


@dataclass(frozen=True)
class Declaration:
    """``#declare M_Clear = material { ... }``."""

    name: Identifier
    value: Part | Value


@dataclass(frozen=True)
class Include:
    """``#include "ball_mesh.inc"``: a file that is written beside this one."""

    file: Quoted


@dataclass(frozen=True)
class Comment:
    """``// a line for the reader``; any text may stand in it, and the printer lets none of it out."""

    text: str


@dataclass(frozen=True)
class Blank:
    """An empty line."""


Part = Statement | Listed | Block | MapEntry | Table | Directive | Declaration | Include | Comment | Blank
"""What stands within a block or at the top of a file."""


@dataclass(frozen=True)
class SdlFile:
    """A whole scene text, part after part."""

    parts: tuple[Part, ...]


Node = Value | Part | SdlFile

# --- making nodes ---------------------------------------------------------------------------------------------------


def vector(value: Sequence[float]) -> Vector:
    return Vector(tuple(value))


def rgb(colour: Sequence[float]) -> Colour:
    red, green, blue = colour
    return Colour((red, green, blue))


def listed(*values: Value) -> Listed:
    return Listed(values)


def statement(*values: Value) -> Statement:
    return Statement(values)


def block(head: str, *parts: Part | None) -> Block:
    """A block of the parts that are there."""
    return Block(head, present(parts))


def present(parts: Iterable[Part | None]) -> tuple[Part, ...]:
    return tuple(part for part in parts if part is not None)


def matrix(axes: tuple[Vec, Vec, Vec], origin: Vec) -> Statement:
    """world = x axes[0] + y axes[1] + z axes[2] + origin, as POV-Ray's row-vector matrix."""
    return statement("matrix", vector([*axes[0], *axes[1], *axes[2], *origin]))
