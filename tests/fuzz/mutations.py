"""Good meshes and skies, and what damage, carelessness or malice makes of them. The same seed makes the same files."""

from __future__ import annotations

import io
import random
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
from plyfile import PlyData, PlyElement

CORNERS = [(x, y, z) for z in (-1.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)]
SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
WORDS = (
    *("0", "1", "-1", "3", "4", "7", "8", "9", "-8", "255", "65536", "2147483648", "4294967295", "99999999999"),
    *("1e308", "-1e300", "1e-320", "nan", "inf", "-inf", "0x10", "1_0", ""),
)
KEYWORDS = (
    *("ascii", "binary_little_endian", "binary_big_endian", "float", "double", "uchar", "char", "ushort", "int"),
    *("uint", "list", "vertex", "face", "x"),
)
LINES = (
    *("", "f 1 2 3", "f 1 2", "f 1//1 2//2 3//3", "v 0 0 0", "vn 0 0 1", "vt 0 0"),
    *("g a", "\\", "comment x", "end_header"),
)

Mutation = Callable[[random.Random, bytes], bytes]


def good_meshes() -> dict[str, bytes]:
    """A cube in every variant that is read."""
    triangles = [each for a, b, c, d in SIDES for each in ((a, b, c), (a, c, d))]
    bent = [(0, 2, 3, 1), *SIDES[1:3], (2, 6, 7), (2, 7, 3), *SIDES[4:]]
    obj = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS)
    obj += "".join("f " + " ".join(str(each + 1) for each in side) + "\n" for side in SIDES)
    made = {"quads.obj": obj.encode(), "normals.obj": (obj + "vn 0.6 0 0.8\n" * 8).replace("f 1 ", "f 1//1 ").encode()}
    for name, order, number, faces in (
        ("ascii.ply", "=", "f8", SIDES),
        ("little.ply", "<", "f4", triangles),
        ("big.ply", ">", "f8", SIDES),
        ("mixed.ply", "<", "f8", bent),
    ):
        made[name] = _ply(order, number, faces, is_text=name == "ascii.ply")
    return made


def _ply(order: str, number: str, sides: list[tuple[int, ...]], *, is_text: bool) -> bytes:
    vertices = np.array(CORNERS, dtype=[(key, number) for key in "xyz"])
    faces = np.empty(len(sides), dtype=[("vertex_indices", object)])
    faces["vertex_indices"] = [np.array(each, "i4") for each in sides]
    out = io.BytesIO()
    elements = [PlyElement.describe(vertices, "vertex"), PlyElement.describe(faces, "face")]
    PlyData(elements, text=is_text, byte_order=order).write(out)
    return out.getvalue()


def good_skies(folder: Path) -> dict[str, bytes]:
    """A sky in the usual kinds of OpenEXR."""
    pixels = np.random.default_rng(1).random((4, 8, 3)).astype(np.float32)
    made = {}
    for compression, type_ in (("none", oiio.FLOAT), ("zip", oiio.HALF), ("rle", oiio.FLOAT), ("piz", oiio.HALF)):
        spec = oiio.ImageSpec(8, 4, 3, type_)
        spec.attribute("compression", compression)
        path = folder / f"{compression}.exr"
        target = oiio.ImageOutput.create(str(path))
        assert target is not None and target.open(str(path), spec) and target.write_image(pixels) and target.close()
        made[path.name] = path.read_bytes()
    return made


def mutated(seed: int, good: dict[str, bytes]) -> tuple[str, bytes]:
    """The name and the bytes of a good file after one to four mutations."""
    chance = random.Random(seed)
    name = chance.choice(sorted(good))
    content = good[name]
    is_text = b"\0" not in content
    for _ in range(chance.choice((1, 1, 1, 2, 4))):
        content = chance.choice(OF_TEXT if is_text else OF_BYTES)(chance, content)
    return name, content


def _flip(chance: random.Random, content: bytes) -> bytes:
    changed = bytearray(content)
    if changed:
        changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def _set(chance: random.Random, content: bytes) -> bytes:
    changed = bytearray(content)
    if changed:
        changed[chance.randrange(len(changed))] = chance.choice((0, 1, 3, 127, 128, 254, 255))
    return bytes(changed)


def _cut(chance: random.Random, content: bytes) -> bytes:
    return content[: chance.randint(0, len(content))]


def _drop(chance: random.Random, content: bytes) -> bytes:
    at = chance.randint(0, len(content))
    return content[:at] + content[at + chance.randint(1, 16) :]


def _repeat(chance: random.Random, content: bytes) -> bytes:
    at = chance.randint(0, len(content))
    return content[:at] + content[max(0, at - chance.randint(1, 32)) : at] + content[at:]


def _word(chance: random.Random, content: bytes) -> bytes:
    """Another word in place of one, in the text of the file: its header or all of it."""
    words = list(re.finditer(rb"[^\s\0]+", content[: max(content.find(b"end_header"), 400)]))
    if not words:
        return content
    start, end = chance.choice(words).span()
    return content[:start] + chance.choice(WORDS + KEYWORDS).encode() + content[end:]


def _line(chance: random.Random, content: bytes) -> bytes:
    """A line gone, doubled, moved or new."""
    lines = content.split(b"\n")
    at, to = chance.randrange(len(lines)), chance.randrange(len(lines))
    match chance.randrange(4):
        case 0:
            del lines[at]
        case 1:
            lines.insert(to, lines[at])
        case 2:
            lines[at], lines[to] = lines[to], lines[at]
        case _:
            lines.insert(to, chance.choice(LINES).encode())
    return b"\n".join(lines)


OF_BYTES: tuple[Mutation, ...] = (_flip, _flip, _set, _cut, _drop, _repeat, _word)
OF_TEXT: tuple[Mutation, ...] = (_flip, _set, _cut, _drop, _word, _word, _word, _line, _line)
