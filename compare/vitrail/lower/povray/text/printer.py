"""The one place where a tree of ``sdl.py`` becomes text: spelling of numbers, checks of words, and layout."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import assert_never

from vitrail.lower.povray.text.sdl import (
    Block,
    Colour,
    Directive,
    Listed,
    MapEntry,
    Part,
    Product,
    Quoted,
    SdlFile,
    Statement,
    Table,
    Value,
    Vector,
)

FLOAT32_LIMIT = 3.0e38
"""Colours and photon positions are single precision in POV-Ray; nothing larger may be written."""
WORD = re.compile(r"[a-z][a-z0-9_]*|#default")
FILE_NAME = re.compile(r"[A-Za-z0-9_]+(\.[A-Za-z0-9_]+)*")
LOOKS = frozenset({"pigment", "normal", "normal_map", "finish", "projected_through"})
"""Blocks that stay on the line they begin on, however long it gets: a look is read as one line."""

TEXTURE_FRAME = len("texture {  }")
"""Characters that a texture has around its parts."""


class UnwritableNumber(ValueError):
    """A number that POV-Ray would silently turn into infinity or refuse."""


class UnwritableWord(ValueError):
    """A word or file name that is none of this package's own."""


@dataclass(frozen=True)
class Layout:
    """How a tree is laid out: a block of at most ``width`` characters stays on one line."""

    width: int = 100
    indent: str = "  "


def printed(file: SdlFile, layout: Layout = Layout()) -> str:
    """The text of a file, one part after the other. Raises UnwritableNumber and UnwritableWord."""
    return "\n".join(part_text(part, layout) for part in file.parts) + "\n"


def part_text(part: Part, layout: Layout = Layout()) -> str:
    match part:
        case Statement() | Listed():
            return _value_text(part)
        case Block():
            return _block_text(_word(part.head), [part_text(each, layout) for each in part.parts], layout)
        case MapEntry():
            return _entry_text(number(part.at), [part_text(each, layout) for each in part.parts], layout)
        case Table():
            return _table_text(part)
        case Directive():
            return f"#{_word(part.word)} {_value_text(part.value)};"
        case _:
            assert_never(part)


def number(value: float) -> str:
    """The shortest decimal that reads back as the same double; zero has no sign."""
    if not math.isfinite(value) or abs(value) > FLOAT32_LIMIT:
        raise UnwritableNumber(f"{value!r} cannot be written as a POV-Ray number")
    text = repr(float(value) + 0.0)
    return text[:-2] if text.endswith(".0") else text


def _value_text(value: Value) -> str:
    match value:
        case float() | int():
            return number(value)
        case str():
            return _word(value)
        case Vector():
            return "<" + ", ".join(number(each) for each in value.numbers) + ">"
        case Colour():
            red, green, blue = value.channels
            return f"rgb {number(red) if red == green == blue else _value_text(Vector(value.channels))}"
        case Product():
            return f"{number(value.factor)}*{_value_text(value.of)}"
        case Quoted():
            if not FILE_NAME.fullmatch(value.text):
                raise UnwritableWord(f"{value.text!r} is no file name that this back end makes")
            return f'"{value.text}"'
        case Listed():
            return ", ".join(_value_text(each) for each in value.values)
        case Statement():
            return " ".join(_value_text(each) for each in value.values)
        case _:
            assert_never(value)


def _word(text: str) -> str:
    if not WORD.fullmatch(text):
        raise UnwritableWord(f"{text!r} is no word of POV-Ray's language")
    return text


def _block_text(head: str, parts: list[str], layout: Layout) -> str:
    """``head { parts }`` on one line where it is short, else one part a line, indented."""
    line = f"{head} {{ {' '.join(parts)} }}"
    if head in LOOKS or (len(line) <= layout.width and "\n" not in line):
        return line
    inner = "\n".join(layout.indent + row for part in parts for row in part.split("\n"))
    return f"{head} {{\n{inner}\n}}"


def _entry_text(at: str, parts: list[str], layout: Layout) -> str:
    """An entry of a map breaks where a texture of the same parts would."""
    line = " ".join(parts)
    if len(line) + TEXTURE_FRAME <= layout.width and "\n" not in line:
        return f"[{at} {line}]"
    return f"[{at} " + f"\n{layout.indent}".join(row for part in parts for row in part.split("\n")) + "]"


def _table_text(table: Table) -> str:
    rows = ",\n".join("<" + ", ".join(map(number, row)) + ">" for row in table.rows)
    return f"{_word(table.head)} {{ {len(table.rows)},\n{rows} }}"
