"""PLY files by plyfile: ASCII or binary of either byte order, triangles or polygons, elements in any order.

Numbers in ASCII are read as doubles whatever the header calls them, so that a vertex keeps every digit that was
written, as in our tracer. A file of triangles alone is read in one sweep; what is not that plain is read row by row,
which also says where a damaged file fails.
"""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from vitrail.geometry.raw_mesh import RawMesh

if TYPE_CHECKING:
    from plyfile import PlyData, PlyElement

_INDICES = ("vertex_indices", "vertex_index")
_LONGEST_HEADER = 2**20
_BROKEN = (AssertionError, KeyError, IndexError, TypeError, AttributeError, StopIteration, MemoryError)
"""What plyfile raises, beside errors of its own and ValueError, for a header or body that it did not expect."""
Columns = Mapping[str, np.ndarray]
"""The values of one element by property: (rows,) numbers, (rows, 3) corners, or (rows,) arrays of corners."""


def read_ply(path: Path, raw: bytes) -> RawMesh:
    """What a PLY file holds; ``raw`` are its bytes. Raises ValueError with what is wrong and where."""
    # A scene without a mesh need not load the reader of meshes.
    from plyfile import PlyData, PlyParseError

    start = _end_of_header(raw)
    head, body = raw[:start], raw[start:]
    try:
        _refuse_too_many(head, len(body))
        # What numpy remarks about a list without numbers is no news to the author of the file.
        with warnings.catch_warnings(action="ignore"):
            if re.search(rb"^format\s+ascii", head, re.MULTILINE):
                head = re.sub(rb"\b(float|float32)\b(?=\s+(x|y|z|nx|ny|nz)\b)", b"double", head)
                found = _sweep(head, body) or _columns(PlyData.read(io.BytesIO(head + body)))
            else:
                found = _columns(_mapped(path, head))
    except (PlyParseError, *_BROKEN) as error:
        raise ValueError(f"it is damaged ({error})") from None
    for name in ("vertex", "face"):
        if name not in found:
            raise ValueError(f"it has no element `{name}`")
    return RawMesh(*_vertices(found["vertex"]), *_faces(found["face"]))


def _end_of_header(raw: bytes) -> int:
    """Where the body begins."""
    found = re.search(rb"^end_header[ \t]*(\r\n|\n|\r)", raw[:_LONGEST_HEADER], re.MULTILINE)
    if found is None:
        raise ValueError(f"its header has no line `end_header` within {_LONGEST_HEADER} bytes")
    return found.end()


def _refuse_too_many(head: bytes, body_bytes: int) -> None:
    """Refuse rows that cannot all be there: a row has a byte for each property, and rows of nothing would never end."""
    elements, counts = _layout(head)
    for part, count in zip(elements, counts, strict=True):
        if count * max(1, len(part.properties)) > body_bytes:
            raise ValueError(f"its {count} rows of `{part.name}` do not fit into the {body_bytes} bytes that follow")


def _columns(data: PlyData) -> dict[str, Columns]:
    return {each.name: {part.name: each[part.name] for part in each.properties} for each in data.elements}


def _mapped(path: Path, head: bytes) -> PlyData:
    """A binary file, mapped into memory where all its faces have three corners, or all four; else row by row."""
    from plyfile import PlyData, PlyParseError

    found = re.search(rb"property\s+list\s+\S+\s+\S+\s+(vertex_ind(?:ices|ex))\b", head)
    for corners in (3, 4):
        if found is None:
            break
        try:
            return PlyData.read(str(path), known_list_len={"face": {found.group(1).decode(): corners}})
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


def _faces(columns: Columns) -> tuple[np.ndarray, np.ndarray]:
    """The corners of all faces, one after the other, and how many each has."""
    name = next((each for each in _INDICES if each in columns), None)
    if name is None:
        raise ValueError("its faces have no list of corners; the property is `vertex_indices`")
    column = columns[name]
    if column.ndim == 2:
        rows, size = column.shape
        return _whole(column.reshape(-1)), np.full(rows, size)
    if column.dtype != object:
        raise ValueError(f"the property `{name}` of its faces is one number, and no list")
    counts = np.array([len(each) for each in column], int)
    return _whole(np.concatenate([*column, np.empty(0)])), counts


def _whole(corners: np.ndarray) -> np.ndarray:
    if not _are_whole(corners):
        raise ValueError("a face names a vertex by what is no whole number")
    return corners.astype(int)
