"""OBJ files: vertices, normals and faces; groups, materials and texture coordinates are passed over."""

from __future__ import annotations

import numpy as np

from vitrail.geometry.raw_mesh import RawMesh


def read_obj(text: str) -> RawMesh:
    """What an OBJ file holds. Normals count where every vertex has one of the same number.

    Faces of two corners, which exporters leave behind for loose edges, enclose nothing and are left out.
    Raises ValueError with the line that is wrong.
    """
    vertices: list[list[float]] = []
    normals: list[list[float]] = []
    faces: list[list[int]] = []
    for number, line in enumerate(text.removeprefix("\N{ZERO WIDTH NO-BREAK SPACE}").splitlines(), start=1):
        words = line.split()
        try:
            match words[:1]:
                case ["v"]:
                    vertices.append(_three(words))
                case ["vn"]:
                    normals.append(_three(words))
                case ["f"]:
                    faces.append([_index(word, len(vertices)) for word in words[1:]])
                case _:
                    continue
        except ValueError as error:
            raise ValueError(f"line {number}: {error}") from None
    kept = np.array(normals) if normals and len(normals) == len(vertices) else None
    solid = [face for face in faces if len(face) > 2]
    return RawMesh(np.array(vertices, float).reshape(-1, 3), kept, solid)


def _three(words: list[str]) -> list[float]:
    if len(words) < 4:
        raise ValueError(f"`{words[0]}` needs three numbers")
    return [float(word) for word in words[1:4]]


def _index(word: str, vertices: int) -> int:
    """A corner's index from 0; OBJ counts from 1, or backwards from the last vertex by negative numbers."""
    given = int(word.split("/")[0])
    found = given - 1 if given > 0 else vertices + given
    if given == 0 or not 0 <= found < max(vertices, 2**31):
        raise ValueError(f"there is no vertex {given}")
    return found
