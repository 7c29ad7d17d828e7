"""OBJ files: vertices, normals and faces; groups, materials and texture coordinates are passed over."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from vitrail.geometry.raw_mesh import RawMesh

BYTE_ORDER_MARK = b"\xef\xbb\xbf"

MOST_INDEX = 2**31
"""More vertices than any file of the allowed size has."""

Corner = tuple[int, int | None]
"""Vertex and normal by number from 0."""


def read_obj(raw: bytes) -> RawMesh:
    """What an OBJ file holds; lines may go on after a backslash. Raises ValueError with the line that is wrong.

    Normals count where every corner names one. A vertex that has several becomes several vertices.
    """
    vertices: list[list[float]] = []
    normals: list[list[float]] = []
    corners: list[Corner] = []
    counts: list[int] = []
    for number, line in _lines(raw):
        words = line.split()
        try:
            match words[:1]:
                case ["v"]:
                    vertices.append(_three(words))
                case ["vn"]:
                    normals.append(_three(words))
                case ["f"]:
                    corners += [_corner(word, len(vertices), len(normals)) for word in words[1:]]
                    counts.append(len(words) - 1)
                case _:
                    continue
        except ValueError as error:
            raise ValueError(f"line {number}: {error}") from None
    places, ways = np.array(vertices, float).reshape(-1, 3), np.array(normals, float).reshape(-1, 3)
    return _with_normals(places, ways, corners, np.array(counts, int))


def _lines(raw: bytes) -> Iterator[tuple[int, str]]:
    """Lines with their numbers; a line that ends in a backslash goes on in the next."""
    if b"\0" in raw:
        raise ValueError("it is no text, and its first word is not `ply`")
    text = raw.removeprefix(BYTE_ORDER_MARK).decode("utf-8", "replace")
    begun, first = "", 1
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), start=1):
        first = first if begun else number
        if line.endswith("\\"):
            begun += line[:-1] + " "
            continue
        yield first, begun + line
        begun = ""
    if begun:
        raise ValueError(f"line {first}: the file ends in the middle of a line")


def _three(words: list[str]) -> list[float]:
    if len(words) < 4:
        raise ValueError(f"`{words[0]}` needs three numbers")
    found = [_number(word) for word in words[1:4]]
    if not np.isfinite(found).all():
        raise ValueError(f"`{words[0]}` is not finite")
    return found


def _number(word: str) -> float:
    if "_" in word:  # which Python allows
        raise ValueError(f"`{word[:40]}` is no number")
    return float(word)


def _corner(word: str, vertices: int, normals: int) -> Corner:
    """The vertex, and the normal where one is named: ``7``, ``7/1``, ``7//3``, ``7/1/3``."""
    parts = word.split("/")
    if len(parts) > 3:
        raise ValueError(f"`{word[:40]}` is no corner of a face")
    way = _index(parts[2], normals, "normal") if len(parts) == 3 and parts[2] else None
    return _index(parts[0], vertices, "vertex"), way


def _index(word: str, known: int, what: str) -> int:
    """An index from 0; OBJ counts from 1, or backwards from the last one by negative numbers."""
    digits = word.removeprefix("-").removeprefix("+")
    if not (digits.isascii() and digits.isdigit() and len(digits) < 20):
        raise ValueError(f"there is no {what} {word[:40]}")
    given = int(word)
    found = given - 1 if given > 0 else known + given
    if given == 0 or not 0 <= found < max(known, MOST_INDEX):
        raise ValueError(f"there is no {what} {given}")
    return found


def _with_normals(vertices: np.ndarray, normals: np.ndarray, corners: list[Corner], counts: np.ndarray) -> RawMesh:
    place = np.array([vertex for vertex, _ in corners], int)
    named = [way for _, way in corners]
    if any(way is not None and way >= len(normals) for way in named):
        raise ValueError(f"a face names a normal that is not among its {len(normals)}")
    if len(normals) == len(vertices) and all(way is None or way == vertex for vertex, way in corners):
        return RawMesh(vertices, normals if len(normals) else None, place, counts)
    if not named or any(way is None for way in named):
        return RawMesh(vertices, None, place, counts)
    # Make a vertex of every pair of place and normal that occurs.
    RawMesh(vertices, None, place, counts)
    pairs, which = np.unique(np.stack([place, np.array(named, int)], axis=1), axis=0, return_inverse=True)
    return RawMesh(vertices[pairs[:, 0]], normals[pairs[:, 1]], which.reshape(-1), counts)
