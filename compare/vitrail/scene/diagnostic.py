"""One message about one place of a scene file, in the form ``file:line:col: what; remedy``."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum


class Severity(StrEnum):
    """An error stops everything after ``check``; a warning is printed and the work goes on."""

    ERROR = "error"
    WARNING = "warning"


@dataclass(frozen=True)
class Diagnostic:
    """What is wrong at ``file:line:col`` (both counted from 1) and what to do about it."""

    file: str
    line: int
    col: int
    what: str
    remedy: str
    severity: Severity = Severity.ERROR

    def __str__(self) -> str:
        label = "warning: " if self.severity is Severity.WARNING else ""
        return f"{self.file}:{self.line}:{self.col}: {label}{self.what}; {self.remedy}"

    @property
    def order(self) -> tuple[str, int, int, str]:
        return (self.file, self.line, self.col, self.what)


class SceneErrors(Exception):
    """Every error found in one scene, in the order of the file."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(sorted(set(diagnostics), key=lambda each: each.order))
        super().__init__("\n".join(str(each) for each in self.diagnostics))
