"""YAML 1.2 text to plain values that remember where they were written.

Only what a scene needs is read: one document of mappings with text keys, sequences and scalars of the core schema.
Everything else (tags, several documents, expanding aliases beyond a limit) is refused with its place.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.events import (
    AliasEvent,
    DocumentStartEvent,
    MappingEndEvent,
    MappingStartEvent,
    ScalarEvent,
    SequenceEndEvent,
    SequenceStartEvent,
)

from vitrail.scene.yaml_scalar import TooLarge, plain_value

MAX_BYTES = 4 * 1024 * 1024
MAX_DEPTH = 32
MAX_NODES = 50_000

Path = tuple[str | int, ...]


class YamlProblem(Exception):
    """Text that is not a scene's YAML: the place (from 1), what is wrong, and the remedy."""

    def __init__(self, line: int, col: int, what: str, remedy: str) -> None:
        self.line, self.col, self.what, self.remedy = line, col, what, remedy
        super().__init__(f"{line}:{col}: {what}; {remedy}")


@dataclass(frozen=True)
class Node:
    """One value of the file; mappings hold (key, key line, key col, value) in the order written."""

    line: int
    col: int
    scalar: Any = None
    items: tuple[Node, ...] | None = None
    pairs: tuple[tuple[str, int, int, Node], ...] | None = None


@dataclass
class Places:
    """Where each value and each key was written, by path from the top of the file."""

    values: dict[Path, tuple[int, int]] = field(default_factory=dict)
    keys: dict[Path, tuple[int, int]] = field(default_factory=dict)

    def of(self, *path: str | int) -> tuple[int, int]:
        """(line, col) of the value at ``path``, or of the nearest part around it that was written."""
        for length in range(len(path), -1, -1):
            if path[:length] in self.values:
                return self.values[path[:length]]
        return (1, 1)

    def of_key(self, *path: str | int) -> tuple[int, int]:
        """(line, col) of the key that introduces ``path``; for list entries that of the entry itself."""
        return self.keys.get(path) or self.of(*path)


def read_yaml(text: str) -> tuple[Any, Places, list[YamlProblem]]:
    """Plain data, its places, and the problems that did not stop the reading (duplicate keys, overflowing numbers).

    Raises YamlProblem where the text cannot be read at all.
    """
    problems: list[YamlProblem] = []
    try:
        root = _compose(YAML(typ="safe", pure=True).parse(text), problems)
    except MarkedYAMLError as error:
        raise _translate(error) from None
    except (YAMLError, ValueError) as error:
        raise YamlProblem(
            1, 1, f"this is not YAML ({str(error).splitlines()[0]})", "write a scene in YAML 1.2"
        ) from None
    if root is None:
        raise YamlProblem(1, 1, "the file is empty", "start with `vitrail: 1`; scenes/README.md shows a whole scene")
    places = Places()
    return _Expansion(places).plain(root, ()), places, problems


# --- events to nodes ------------------------------------------------------------------------------------------------


def _compose(events: Iterator[Any], problems: list[YamlProblem]) -> Node | None:
    """The node of the only document, or None for an empty file."""
    composer, root = _Composer(events, problems), None
    for event in events:
        if not isinstance(event, DocumentStartEvent):
            continue
        line, col = _place(event)
        if root is not None:
            raise YamlProblem(
                line, col, "the file holds a second document", "write one scene a file, without `---` inside"
            )
        if event.version is not None and tuple(event.version) != (1, 2):
            raise YamlProblem(
                line, col, "the file asks for another YAML version", "drop the %YAML line; scenes are YAML 1.2"
            )
        first = next(events)
        root = composer.node(first, depth=0) if event.explicit or not _is_void(first) else None
        if root is not None and root.scalar is None and root.items is None and root.pairs is None:
            root = None
    return root


def _is_void(event: Any) -> bool:
    return isinstance(event, ScalarEvent) and event.style is None and event.value == ""


class _Composer:
    """Build nodes from parser events, with limits on depth and on their number."""

    def __init__(self, events: Iterator[Any], problems: list[YamlProblem]) -> None:
        self.events, self.problems = events, problems
        self.anchors: dict[str, Node] = {}
        self.count = 0

    def node(self, event: Any, depth: int) -> Node:
        line, col = _place(event)
        self.count += 1
        if self.count > MAX_NODES:
            raise YamlProblem(
                line, col, f"the file has more than {MAX_NODES} values", "put large geometry into a mesh file"
            )
        if depth > MAX_DEPTH:
            raise YamlProblem(
                line, col, f"nested deeper than {MAX_DEPTH} levels", "a scene needs six levels; flatten it"
            )
        if isinstance(event, AliasEvent):
            if event.anchor not in self.anchors:
                raise YamlProblem(
                    line, col, f"alias `*{event.anchor}` stands for nothing finished before it", "write the value out"
                )
            return self.anchors[event.anchor]
        if event.tag is not None:
            raise YamlProblem(
                line, col, f"the tag `{event.tag}` is not part of a scene", "remove the tag and write the plain value"
            )
        if isinstance(event, ScalarEvent):
            made = Node(line, col, scalar=self._scalar(event))
        elif isinstance(event, SequenceStartEvent):
            made = Node(line, col, items=tuple(self._items(depth)))
        else:
            assert isinstance(event, MappingStartEvent)
            made = Node(line, col, pairs=tuple(self._pairs(depth)))
        if event.anchor is not None:
            self.anchors[event.anchor] = made
        return made

    def _items(self, depth: int) -> Iterator[Node]:
        while not isinstance(event := next(self.events), SequenceEndEvent):
            yield self.node(event, depth + 1)

    def _pairs(self, depth: int) -> Iterator[tuple[str, int, int, Node]]:
        seen: dict[str, int] = {}
        while not isinstance(event := next(self.events), MappingEndEvent):
            line, col = _place(event)
            key = self.node(event, depth + 1)
            value = self.node(next(self.events), depth + 1)
            if not isinstance(key.scalar, str):
                remedy = 'put a name that looks like a number or a word of YAML in quotes, as in "1":'
                self.problems.append(YamlProblem(line, col, "a key must be text", remedy))
            elif key.scalar in seen:
                what = f"the key `{key.scalar}` was already given in line {seen[key.scalar]}"
                self.problems.append(YamlProblem(line, col, what, "keep one of the two"))
            else:
                seen[key.scalar] = line
                yield (key.scalar, line, col, value)

    def _scalar(self, event: ScalarEvent) -> Any:
        """The value of a scalar by the YAML 1.2 core schema; quoted text stays text."""
        text = event.value
        if any("\ud800" <= character <= "\udfff" for character in text):
            self.problems.append(YamlProblem(*_place(event), "half of a character pair is no text", "write it whole"))
            return ""
        if event.style is not None:
            return text
        try:
            return plain_value(text)
        except TooLarge:
            shown = text if len(text) <= 24 else text[:20] + "..."
            what = f"{shown} is too large for a number"
            self.problems.append(YamlProblem(*_place(event), what, "the largest is 1.8e308"))
            return 0.0


def _place(event: Any) -> tuple[int, int]:
    return (event.start_mark.line + 1, event.start_mark.column + 1)


# --- nodes to plain data --------------------------------------------------------------------------------------------


@dataclass
class _Expansion:
    """Write aliases out, counting what they expand to, so that a small file cannot fill the memory."""

    places: Places
    count: int = 0

    def plain(self, node: Node, path: Path) -> Any:
        self.count += 1
        if self.count > MAX_NODES:
            what = f"its aliases expand to more than {MAX_NODES} values"
            raise YamlProblem(node.line, node.col, what, "write the values out, or put large geometry into a mesh file")
        self.places.values[path] = (node.line, node.col)
        if node.items is not None:
            return [self.plain(item, (*path, index)) for index, item in enumerate(node.items)]
        if node.pairs is not None:
            for key, line, col, _ in node.pairs:
                self.places.keys[(*path, key)] = (line, col)
            return {key: self.plain(value, (*path, key)) for key, _, _, value in node.pairs}
        return node.scalar


_REMEDIES = (
    (r"\t", "indent with spaces; YAML forbids tabs there"),
    ("expected ',' or ']'", "close the list with `]`, or separate its entries with commas"),
    ("expected ',' or '}'", "close the mapping with `}`, or separate its entries with commas"),
    ("mapping values are not allowed", "put a space after the colon and check the indentation of this line"),
    ("could not find expected ':'", "write `key: value`"),
    ("expected <block end>", "check the indentation of this line"),
    ("special characters", "save the file as plain UTF-8 text"),
    ("duplicate anchor", "give each anchor its own name, or write the value out"),
    ("expected alphabetic", "put text that starts with `&`, `*` or `!` in quotes"),
    ("undefined alias", "write the value out"),
    ("undefined tag", "remove the tag"),
)


def _translate(error: MarkedYAMLError) -> YamlProblem:
    """A parser's complaint with its place and a remedy in a scene author's words."""
    mark = error.problem_mark or error.context_mark
    problem = (error.problem or "cannot be read").strip()
    remedy = next(
        (text for key, text in _REMEDIES if key in problem), "check the brackets, quotes and indentation there"
    )
    line, col = (mark.line + 1, mark.column + 1) if mark is not None else (1, 1)
    return YamlProblem(line, col, f"this is not YAML: {problem}", remedy)
