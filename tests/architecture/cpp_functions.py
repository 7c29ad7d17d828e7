"""The functions of a C++ file and how long they are, found by tokens and braces: no compiler, no preprocessor."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

TOKEN = re.compile(
    r"""
      (?P<skip> //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:[^\n\\]|\\.|\\\n)* )
    | (?P<text> R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)" | "(?:[^"\\\n]|\\.)*" | '(?:[^'\\\n]|\\.)*' )
    | (?P<operator> \boperator\s*(?:\(\s*\)|\[\s*\]|[^\s\w(]+) )
    | (?P<word> [A-Za-z_]\w* | \d(?:[\w.]|'\d)* )
    | (?P<sign> :: | . )
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)

CONTAINERS = {"namespace", "class", "struct", "union", "enum", "extern"}


@dataclass(frozen=True)
class Function:
    """A definition: its name as written, the line of its first word, and the lines up to its closing brace."""

    name: str
    line: int
    lines: int


Token = tuple[str, int]
"""A word or sign, and its line."""


def tokens_of(source: str) -> list[Token]:
    """Words, signs and texts without comments and preprocessor lines."""
    tokens = []
    line, place = 1, 0
    for match in TOKEN.finditer(source):
        line += source.count("\n", place, match.start())
        place = match.start()
        if match.lastgroup != "skip" and not match.group().isspace():
            tokens.append(('""' if match.group("text") else match.group(), line))
    return tokens


def functions_of(source: str) -> Iterator[Function]:
    """Every function that is defined in a namespace or a class. Lambdas and local classes belong to theirs."""
    tokens = tokens_of(source)
    head: list[Token] = []
    place = 0
    while place < len(tokens):
        word, _ = tokens[place]
        if word == "{" and not _opens_a_scope(head):
            end = _end_of_block(tokens, place)
            if _opens_a_body(head):
                yield Function(_name_of(head), head[0][1], tokens[end][1] - head[0][1] + 1)
                head = []
            else:  # an initialiser, which belongs to what is being declared
                head.append(("{}", tokens[end][1]))
            place = end
        elif word in {"{", "}", ";"} or (word == ":" and _is_access(head)):
            head = []
        else:
            head.append(tokens[place])
        place += 1


def _end_of_block(tokens: list[Token], place: int) -> int:
    """The place of the brace that closes the one at ``place``."""
    depth = 0
    for end in range(place, len(tokens)):
        depth += {"{": 1, "}": -1}.get(tokens[end][0], 0)
        if depth == 0:
            return end
    raise ValueError(f"line {tokens[place][1]}: a brace that nothing closes")


def _outside_brackets(head: list[Token]) -> list[str]:
    """The words of a head without what is in parentheses or template brackets; ``()`` stands for a parenthesis."""
    words = []
    depth = 0
    for word, _ in head:
        if word in {"(", "[", "<"}:
            if depth == 0 and word == "(":
                words.append("()")
            depth += 1
        elif word in {")", "]", ">"}:
            depth = max(0, depth - 1)
        elif depth == 0:
            words.append(word)
    return words


def _opens_a_scope(head: list[Token]) -> bool:
    """Whether a brace after these words opens a namespace or a class."""
    words = [word for word in _outside_brackets(head) if word not in {"template", "inline", "typedef", "static"}]
    return bool(words) and words[0] in CONTAINERS and "=" not in words


def _opens_a_body(head: list[Token]) -> bool:
    """Whether it opens the body of a function: there are parameters, and no member is being initialised."""
    words = _outside_brackets(head)
    unclosed = sum({"(": 1, ")": -1}.get(word, 0) for word, _ in head)
    if unclosed or "()" not in words or "=" in words[: words.index("()")]:
        return False
    after = words[words.index("()") + 1 :]
    return ":" not in after or after[-1] in {"()", "{}"}


def _is_access(head: list[Token]) -> bool:
    return len(head) == 1 and head[0][0] in {"public", "private", "protected"}


def _name_of(head: list[Token]) -> str:
    """What stands before the parameters."""
    words = [word for word, _ in head]
    opening = words.index("(")
    first = opening - 1
    while first >= 2 and words[first - 1] == "::":
        first -= 2
    return "".join(words[first:opening])
