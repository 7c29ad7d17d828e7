"""The sentences of a Markdown page, and how many words each has."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

FENCED = re.compile(r"^ *```.*?^ *```", re.DOTALL | re.MULTILINE)
CODE = re.compile(r"(`+)(?!`).+?(?<!`)\1(?!`)", re.DOTALL)
LINK = re.compile(r"!?\[([^\]]*)\](?:\([^)]*\)|\[[^\]]*\])")
ITEM = re.compile(r"\s*(?:[*+-]|\d+\.)\s+")
END = re.compile(r"(?<=[.!?])(?<!\be\.g\.)(?<!\bi\.e\.)[)\"*_]*\s+(?=[^a-z])|(?<=[:;])\s+(?=[A-Z*])")
"""A full stop, question or exclamation mark, or a colon or semicolon with a capital after it."""

WORD = re.compile(r"[^\W_]")
"""What makes a run of signs a word: a letter or a digit. A dash or a multiplication sign is none."""


@dataclass(frozen=True)
class Sentence:
    """The line (from 1) on which its paragraph begins, its text without line breaks, and its words."""

    line: int
    text: str

    @property
    def words(self) -> int:
        """Code in backquotes is one word, a link is its text."""
        shown = LINK.sub(r"\1", CODE.sub("code", self.text))
        return sum(1 for word in shown.split() if WORD.search(word))


def sentences_of(page: str) -> Iterator[Sentence]:
    """Every sentence; headings and code blocks are none, a cell of a table or a list item ends with its last word."""
    for line, text in _paragraphs(FENCED.sub(lambda block: "\n" * block.group().count("\n"), page)):
        codes = (match.group() for match in CODE.finditer(text))
        for part in END.split(CODE.sub("``", text)):
            shown = _filled(part, codes).strip()
            if shown:
                yield Sentence(line, shown)


def _filled(part: str, codes: Iterator[str]) -> str:
    """The part with its code in place again, so that no full stop inside code has ended a sentence."""
    return re.sub("``", lambda _: next(codes), part)


def _paragraphs(page: str) -> Iterator[tuple[int, str]]:
    """Line and text of every paragraph, list item and cell of a table."""
    begun, held = 0, [""]
    for number, line in enumerate([*page.splitlines(), ""], 1):
        is_code = line.startswith("    ") and not held[-1]
        is_row = line.startswith("|")
        if not line.strip() or line.startswith("#") or is_code or is_row or ITEM.match(line):
            yield begun, " ".join(held).strip()
            held = [""]
        if is_row:
            yield from ((number, cell.strip()) for cell in re.split(r"(?<!\\)\|", line.strip("|")))
        elif line.strip() and not line.startswith("#") and not is_code:
            begun = begun if held[-1] else number
            held.append(ITEM.sub("", line, count=1).strip() if ITEM.match(line) else line.strip())
