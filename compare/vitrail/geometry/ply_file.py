"""PLY files by plyfile: ASCII or binary of either byte order, triangles or polygons.

Numbers in ASCII are read as doubles whatever the header calls them, so that a vertex keeps every digit that was
written, as in our tracer. A file of triangles alone is read in one sweep; what is not that plain is read row by row,
which also says where a damaged file fails.
"""

from __future__ import annotations

import io
import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from vitrail.geometry.raw_mesh import RawMesh

if TYPE_CHECKING:
    from plyfile import PlyData, PlyElement

_INDICES = ("vertex_indices", "vertex_index")
Columns = Mapping[str, np.ndarray]
"""The values of one element by property: (rows,) numbers, (rows, 3) corners, or (rows,) arrays of corners."""


def read_ply(path: Path, raw: bytes) -> RawMesh:
    """What a PLY file holds; ``raw`` are its bytes. Raises ValueError with what is wrong and where."""
    # A scene without a mesh need not load the reader of meshes.
    from plyfile import PlyData, PlyParseError

    start = raw.find(b"\n", raw.find(b"end_header")) + 1
    head, body = raw[:start], raw[start:]
    try:
        if re.search(rb"^format\s+ascii", head, re.MULTILINE):
            head = re.sub(rb"\b(float|float32)\b(?=\s+(x|y|z|nx|ny|nz)\b)", b"double", head)
            found = _sweep(head, body) or _columns(PlyData.read(io.BytesIO(head + body)))
        else:
            found = _columns(_mapped(path, head))
    except PlyParseError as error:
        raise ValueError(str(error)) from None
    for name in ("vertex", "face"):
        if name not in found:
            raise ValueError(f"it has no element `{name}`")
    return RawMesh(*_vertices(found["vertex"]), _faces(found["face"]))


def _columns(data: PlyData) -> dict[str, Columns]:
    return {each.name: {part.name: each[part.name] for part in each.properties} for each in data.elements}


def _mapped(path: Path, head: bytes) -> PlyData:
    """A binary file, mapped into memory where all its faces have three corners, else row by row."""
    from plyfile import PlyData, PlyParseError

    found = re.search(rb"property\s+list\s+\S+\s+\S+\s+(vertex_ind(?:ices|ex))\b", head)
    if found:
        try:
            return PlyData.read(str(path), known_list_len={"face": {found.group(1).decode(): 3}})
        except PlyParseError:
            pass
    return PlyData.read(str(path))


def _sweep(head: bytes, body: bytes) -> dict[str, Columns] | None:
    """All numbers of an ASCII file at once; None unless they are exactly those of a file of triangles alone."""
    from plyfile import PlyListProperty

    elements, counts = _layout(head)
    widths = [sum(4 if isinstance(each, PlyListProperty) else 1 for each in part.properties) for part in elements]
    try:
        numbers = np.array(body.split(), float)
    except ValueError:
        return None
    if len(numbers) != sum(width * count for width, count in zip(widths, counts, strict=True)):
        return None
    found: dict[str, Columns] = {}
    start = 0
    for width, count, part in zip(widths, counts, elements, strict=True):
        rows = numbers[start : start + width * count].reshape(count, width)
        start += rows.size
        columns: dict[str, np.ndarray] = {}
        at = 0
        for each in part.properties:
            if isinstance(each, PlyListProperty):
                if not (rows[:, at] == 3).all() or not _are_whole(rows[:, at + 1 : at + 4]):
                    return None
                columns[each.name], at = rows[:, at + 1 : at + 4], at + 4
            else:
                columns[each.name], at = rows[:, at], at + 1
        found[part.name] = columns
    return found


def _layout(head: bytes) -> tuple[tuple[PlyElement, ...], list[int]]:
    """The elements with their properties, and how many rows each has, from the header alone."""
    from plyfile import PlyData

    element = re.compile(rb"^(element\s+\S+\s+)(\d+)", re.MULTILINE)
    without_rows = element.sub(rb"\g<1>0", head)
    counts = [int(count) for _, count in element.findall(head)]
    return PlyData.read(io.BytesIO(without_rows)).elements, counts


def _are_whole(values: np.ndarray) -> bool:
    return bool((np.isfinite(values) & (values == np.floor(values)) & (np.abs(values) < 2**31)).all())


def _vertices(columns: Columns) -> tuple[np.ndarray, np.ndarray | None]:
    if not {"x", "y", "z"} <= set(columns):
        raise ValueError("its vertices have no x, y and z")
    vertices = np.stack([np.asarray(columns[key], float) for key in "xyz"], axis=1)
    if not {"nx", "ny", "nz"} <= set(columns):
        return vertices, None
    return vertices, np.stack([np.asarray(columns[key], float) for key in ("nx", "ny", "nz")], axis=1)


def _faces(columns: Columns) -> list[list[int]] | np.ndarray:
    name = next((each for each in _INDICES if each in columns), None)
    if name is None:
        raise ValueError("its faces have no list of corners; the property is `vertex_indices`")
    column = columns[name]
    if column.ndim == 2:
        return np.asarray(column, int)
    if column.dtype != object:
        raise ValueError(f"the property `{name}` of its faces is one number, and no list")
    return [[int(each) for each in corners] for corners in column]
