"""Change a tree of ``sdl.py`` node by node: for defects put in on purpose, and for tests.

An edit names the node it changes, never how it is printed, so no change of layout can disarm it. An edit that finds
nothing is an error: a defect that changes nothing tests nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from vitrail.lower.povray.text.sdl import Block, Colour, Declaration, MapEntry, Part, SdlFile, Statement, Value

Edit = Callable[[Part], Part]
"""The part to put in the place of a part, or the same one; it sees inner parts before outer ones."""


class NothingToEdit(ValueError):
    """A scene without a single node that an edit is about."""


def edited(file: SdlFile, edit: Edit) -> SdlFile:
    """The file with every part edited; the same object where nothing changed."""
    parts = _all_edited(file.parts, edit)
    return file if parts is file.parts else SdlFile(parts)


def blocks(head: str, change: Callable[[Block], Block]) -> Edit:
    """Edit the blocks of one kind."""
    return lambda part: change(part) if isinstance(part, Block) and part.head == head else part


def statements(keyword: str, *values: Value, to: tuple[Value, ...]) -> Edit:
    """Replace the statements ``keyword values``, all those of the keyword where no values are given."""

    def edit(part: Part) -> Part:
        if not isinstance(part, Statement) or part.keyword != keyword or (values and part.values[1:] != values):
            return part
        return Statement((keyword, *to))

    return edit


def coloured(change: Callable[[Colour], Colour]) -> Callable[[Block], Block]:
    """Edit the colours in the statements of a block, not in blocks within it."""

    def statement(part: Part) -> Part:
        if not isinstance(part, Statement):
            return part
        return Statement(tuple(change(each) if isinstance(each, Colour) else each for each in part.values))

    return lambda block: Block(block.head, tuple(statement(part) for part in block.parts))


def found(file: SdlFile, head: str) -> Iterator[Block]:
    """Every block of one kind, outer ones first."""
    waiting = list(file.parts)
    while waiting:
        part = waiting.pop(0)
        if isinstance(part, Block | MapEntry):
            waiting[:0] = part.parts
        if isinstance(part, Block) and part.head == head:
            yield part


def values_of(block: Block, keyword: str) -> tuple[Value, ...] | None:
    """What follows a keyword in a block; None where it does not occur."""
    for part in block.parts:
        if isinstance(part, Statement) and part.keyword == keyword:
            return part.values[1:]
    return None


def _all_edited(parts: tuple[Part, ...], edit: Edit) -> tuple[Part, ...]:
    made = tuple(edit(_with_edited_parts(part, edit)) for part in parts)
    # Let what is written as before be the same object, so that an edit without effect shows.
    return parts if made == parts else made


def _with_edited_parts(part: Part, edit: Edit) -> Part:
    match part:
        case Block():
            inner = _all_edited(part.parts, edit)
            return part if inner is part.parts else Block(part.head, inner)
        case MapEntry():
            inner = _all_edited(part.parts, edit)
            return part if inner is part.parts else MapEntry(part.at, inner)
        case Declaration() if isinstance(part.value, Block):
            (value,) = _all_edited((part.value,), edit)
            return part if value is part.value else Declaration(part.name, value)
        case _:
            return part
