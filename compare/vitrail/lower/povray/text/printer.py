"""The one place where a tree of ``sdl.py`` becomes text: spelling of numbers, checks of words, and layout."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import assert_never

from vitrail.lower.povray.text.sdl import (
    Blank,
    Block,
    Call,
    Colour,
    Comment,
    Declaration,
    Directive,
    Identifier,
    Include,
    Listed,
    MapEntry,
    Part,
    Product,
    Quoted,
    Quotient,
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
IDENTIFIER = re.compile(r"[A-Z][A-Za-z0-9_]{0,39}")
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
    """How a tree is laid out: a block of at most ``width`` characters stays on one line, ``one_line`` heads always.

    ``digits`` rounds numbers to as many significant ones; with ``breaks_lists`` a long list has one value a line.
    """

    width: int = 100
    indent: str = "  "
    one_line: frozenset[str] = LOOKS
    digits: int | None = None
    breaks_lists: bool = False

    def number(self, value: float) -> str:
        return number(value if self.digits is None else float(f"{value:.{self.digits}g}"))


def printed(file: SdlFile, layout: Layout = Layout()) -> str:
    """The text of a file, one part after the other. Raises UnwritableNumber and UnwritableWord."""
    return "\n".join(part_text(part, layout) for part in file.parts) + "\n"


def part_text(part: Part, layout: Layout) -> str:
    match part:
        case Statement() | Listed():
            return _line_text(part, layout)
        case Block():
            return _block_text(_word(part.head), [part_text(each, layout) for each in part.parts], layout)
        case MapEntry():
            return _entry_text(layout.number(part.at), [part_text(each, layout) for each in part.parts], layout)
        case Table():
            return _table_text(part, layout)
        case Directive():
            return f"#{_word(part.word)} {_value_text(part.value, layout)};"
        case Declaration():
            return f"#declare {_value_text(part.name, layout)} = {_declared_text(part.value, layout)}"
        case Include():
            return f"#include {_value_text(part.file, layout)}"
        case Comment():
            return f"// {comment_text(part.text)}".rstrip()
        case Blank():
            return ""
        case _:
            assert_never(part)


def number(value: float) -> str:
    """The shortest decimal that reads back as the same double; zero has no sign."""
    if not math.isfinite(value) or abs(value) > FLOAT32_LIMIT:
        raise UnwritableNumber(f"{value!r} cannot be written as a POV-Ray number")
    text = repr(float(value) + 0.0)
    return text[:-2] if text.endswith(".0") else text


def _line_text(part: Statement | Listed, layout: Layout) -> str:
    """A statement on its line; a list that is too long for it one value a line, where the layout breaks lists."""
    line = _value_text(part, layout)
    if not layout.breaks_lists or len(line) <= layout.width:
        return line
    *words, last = part.values if isinstance(part, Statement) else (part,)
    if not isinstance(last, Listed):
        return line
    values = f",\n{layout.indent}".join(_value_text(each, layout) for each in last.values)
    return " ".join([*(_value_text(each, layout) for each in words), values])


def _value_text(value: Value, layout: Layout) -> str:
    match value:
        case float() | int():
            return layout.number(value)
        case str():
            return _word(value)
        case Vector():
            return "<" + ", ".join(layout.number(each) for each in value.numbers) + ">"
        case Colour():
            red, green, blue = (layout.number(each) for each in value.channels)
            return f"rgb {red}" if red == green == blue else f"rgb <{red}, {green}, {blue}>"
        case Product():
            return f"{_value_text(value.factor, layout)}*{_value_text(value.of, layout)}"
        case Quotient():
            return f"{_value_text(value.above, layout)}/{_value_text(value.below, layout)}"
        case Call():
            arguments = ", ".join(_value_text(each, layout) for each in value.arguments)
            return f"{_word(value.function)}({arguments})"
        case Identifier():
            if not IDENTIFIER.fullmatch(value.name):
                raise UnwritableWord(f"{value.name!r} is no identifier that this back end makes")
            return value.name
        case Quoted():
            if not FILE_NAME.fullmatch(value.text):
                raise UnwritableWord(f"{value.text!r} is no file name that this back end makes")
            return f'"{value.text}"'
        case Listed():
            return ", ".join(_value_text(each, layout) for each in value.values)
        case Statement():
            return " ".join(_value_text(each, layout) for each in value.values)
        case _:
            assert_never(value)


def _word(text: str) -> str:
    if not WORD.fullmatch(text):
        raise UnwritableWord(f"{text!r} is no word of POV-Ray's language")
    return text


def _declared_text(value: Part | Value, layout: Layout) -> str:
    """A block as it is; a value ends with a semicolon."""
    if isinstance(value, Block):
        return part_text(value, layout)
    assert not isinstance(value, MapEntry | Table | Directive | Declaration | Include | Comment | Blank)
    return f"{_value_text(value, layout)};"


def comment_text(text: str) -> str:
    """The text in printable ASCII, on one line, with nothing in it that begins or ends a comment."""
    plain = "".join(each if " " <= each <= "~" else each.encode("unicode_escape").decode("ascii") for each in text)
    return plain.replace("*/", "* /").replace("/*", "/ *")


def _block_text(head: str, parts: list[str], layout: Layout) -> str:
    """``head { parts }`` on one line where it is short, else one part a line, indented."""
    line = f"{head} {{ {' '.join(parts)} }}"
    has_comment = any(part.startswith("//") for part in parts)
    if not has_comment and (head in layout.one_line or (len(line) <= layout.width and "\n" not in line)):
        return line
    inner = "\n".join(layout.indent + row for part in parts for row in part.split("\n"))
    return f"{head} {{\n{inner}\n}}"


def _entry_text(at: str, parts: list[str], layout: Layout) -> str:
    """An entry of a map breaks where a texture of the same parts would."""
    line = " ".join(parts)
    if len(line) + TEXTURE_FRAME <= layout.width and "\n" not in line:
        return f"[{at} {line}]"
    return f"[{at} " + f"\n{layout.indent}".join(row for part in parts for row in part.split("\n")) + "]"


def _table_text(table: Table, layout: Layout) -> str:
    rows = ",\n".join("<" + ", ".join(map(layout.number, row)) + ">" for row in table.rows)
    return f"{_word(table.head)} {{ {len(table.rows)},\n{rows} }}"
