"""What the architecture tests look at: the files of the project, their imports, and the tables of docs/layers.md."""

from __future__ import annotations

import ast
import re
import subprocess
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "compare" / "vitrail"
TRACER = ROOT / "tracer"

INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.MULTILINE)
CPP_SUFFIXES = (".h", ".cc", ".cpp")


def project_files() -> list[Path]:
    """Every file that is or would be committed, relative to the root."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    ).stdout.splitlines()
    return sorted(Path(name) for name in set(listed) if (ROOT / name).is_file())


def python_modules() -> dict[str, Path]:
    """Dotted module name to file, for the package."""
    modules = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
        modules[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return modules


@cache
def imported_names(path: Path) -> tuple[tuple[int, str], ...]:
    """Line and dotted name of everything a Python file imports, inside functions too.

    ``from a.b import c`` gives both ``a.b`` and ``a.b.c``, because ``c`` may be a module.
    """
    found: list[tuple[int, str]] = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found += [(node.lineno, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}:{node.lineno}: write the import with its full name"
            assert node.module is not None
            found += [(node.lineno, node.module), *((node.lineno, f"{node.module}.{each.name}") for each in node.names)]
    return tuple(found)


def cpp_files() -> list[Path]:
    return sorted(path for path in TRACER.rglob("*") if path.suffix in CPP_SUFFIXES)


@cache
def included_names(path: Path) -> list[str]:
    """Everything a C++ file includes, as written, in order."""
    return [name for _, name in INCLUDE.findall(path.read_text(encoding="utf-8"))]


def own_header(name: str) -> Path | None:
    """The file of ours that an include names, relative to ``tracer/``; None for a foreign header."""
    plain = name.removeprefix("tracer/")
    return Path(plain) if (TRACER / plain).is_file() else None


def table(heading: str) -> list[list[str]]:
    """The rows of the table under one heading of docs/layers.md, header left out, cells as lists of `quoted` words."""
    text = (ROOT / "docs" / "layers.md").read_text(encoding="utf-8")
    section = text.split(f"## {heading}", 1)[1].split("\n## ", 1)[0]
    rows = [line.strip().strip("|").split("|") for line in section.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in row] for row in rows[2:]]


def quoted(cell: str) -> list[str]:
    """The words in backquotes of one cell."""
    return re.findall(r"`([^`]+)`", cell)


def allowed(heading: str) -> dict[str, set[str]]:
    """Folder to the folders it may use, itself included."""
    return {quoted(row[0])[0]: {*quoted(row[0]), *quoted(row[2])} for row in table(heading)}


def find_cycle(edges: dict[str, set[str]]) -> list[str] | None:
    """One closed path through a directed graph, or None."""
    state: dict[str, int] = {}
    path: list[str] = []

    def visit(node: str) -> list[str] | None:
        state[node] = 1
        path.append(node)
        for following in sorted(edges.get(node, ())):
            if state.get(following) == 1:
                return [*path[path.index(following) :], following]
            if following not in state and (cycle := visit(following)):
                return cycle
        path.pop()
        state[node] = 2
        return None

    for start in sorted(edges):
        if start not in state and (cycle := visit(start)):
            return cycle
    return None
