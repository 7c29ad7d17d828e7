#!/usr/bin/env python3
"""Measure the structure of the code and print it as a table, today's beside that of an earlier commit.

    .venv/bin/python tools/structure.py [--against COMMIT]

Every figure is read from the files or from one run of the program:

* files that name a shape: those with the word ``Lens``, which every shape's places share;
* matches on a shape: ``match`` statements with three or more cases of shapes;
* ``Any`` and ``dict[str, Any]``: uses in the package;
* the walk: whoever follows the scene (today the ``World`` that holds it) through ``lower_povray``, from call to call. A
  *move* goes to another file, a *climb* to a file of a higher layer, a *return* to a file seen before;
* lines of files and functions, median and 95th percentile (C++ functions are found by their braces);
* repeated lines: lines of code in runs of six or more that stand in a second place too.
"""

from __future__ import annotations

import argparse
import ast
import re
import statistics
import subprocess
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SHAPES = {"Sphere", "Plane", "Rectangle", "Disc", "Box", "Cylinder", "Cone", "Prism", "Lens", "Mesh"}
RUN = 6
"""Lines that make a repetition."""
WALKED = "vitrail.lower.povray.lower:lower_povray"
"""Where the walk begins, with the first parameter."""


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure the structure of the code.")
    parser.add_argument("--against", metavar="COMMIT", help="an earlier commit to measure too")
    before = parser.parse_args().against
    columns = {"today": measured(ROOT)}
    if before:
        with tempfile.TemporaryDirectory() as folder:
            tree = Path(folder) / "tree"
            subprocess.run(["git", "worktree", "add", "-q", "--detach", str(tree), before], cwd=ROOT, check=True)
            try:
                columns = {before: measured(tree), **columns}
            finally:
                subprocess.run(["git", "worktree", "remove", "--force", str(tree)], cwd=ROOT, check=True)
    print("| measure | " + " | ".join(columns) + " |")
    print("|---|" + "---|" * len(columns))
    for row in columns["today"]:
        print(f"| {row} | " + " | ".join(column[row] for column in columns.values()) + " |")


def measured(tree: Path) -> dict[str, str]:
    """Every figure of one checkout, by the words of its row."""
    python = sorted((tree / "compare" / "vitrail").rglob("*.py"))
    cpp = sorted(path for path in (tree / "tracer").rglob("*") if path.suffix in {".h", ".cc"})
    texts = {path: path.read_text(encoding="utf-8") for path in [*python, *cpp]}
    package = "\n".join(line for path in python for line in texts[path].splitlines() if "import" not in line)
    moves = walk(tree)
    return {
        "Python files that name a shape": str(sum(bool(re.search(r"\bLens\b", texts[path])) for path in python)),
        "C++ files that name a shape": str(sum(bool(re.search(r"\bLens\b", texts[path])) for path in cpp)),
        "Python matches on a shape": str(sum(matches_on_shapes(ast.parse(texts[path])) for path in python)),
        "`Any` in the package": str(len(re.findall(r"\bAny\b", package))),
        "`dict[str, Any]` in the package": str(package.count("dict[str, Any]")),
        "walk through the POV-Ray lowering: moves": str(moves["moves"]),
        "… of them climbs": str(moves["climbs"]),
        "… of them returns": str(moves["returns"]),
        "Python files: lines, median / p95 / longest": spread([len(texts[path].splitlines()) for path in python]),
        "Python functions: lines, median / p95 / longest": spread(
            [length for path in python for length in python_functions(texts[path])]
        ),
        "C++ files: lines, median / p95 / longest": spread([len(texts[path].splitlines()) for path in cpp]),
        "C++ functions: lines, median / p95 / longest": spread(
            [length for path in cpp for length in cpp_functions(texts[path])]
        ),
        "repeated lines, Python": f"{repeated([texts[path] for path in python])} of {lines_of(texts, python)}",
        "repeated lines, C++": f"{repeated([texts[path] for path in cpp])} of {lines_of(texts, cpp)}",
    }


def matches_on_shapes(tree: ast.AST) -> int:
    """How many ``match`` statements of a module tell three shapes or more apart."""
    found = 0
    for node in ast.walk(tree):
        if isinstance(node, ast.Match):
            names = {
                each.cls.id
                for case in node.cases
                for each in ast.walk(case.pattern)
                if isinstance(each, ast.MatchClass) and isinstance(each.cls, ast.Name)
            }
            found += len(names & SHAPES) >= 3
    return found


def walk(tree: Path) -> dict[str, int]:
    """Moves, climbs and returns between files of whoever follows the first parameter of ``WALKED``."""
    module, name = WALKED.split(":")
    files = list(Walk(tree / "compare").follow(module, name, 0))
    floors = layers(tree)
    counts, seen = Counter({"moves": 0, "climbs": 0, "returns": 0}), {files[0]}
    for here, there in zip(files, files[1:], strict=False):
        if here == there:
            continue
        counts["moves"] += 1
        counts["climbs"] += floors.index(there.split(".")[1]) > floors.index(here.split(".")[1])
        counts["returns"] += there in seen
        seen.add(there)
    return dict(counts)


class Walk:
    """Follows a value through the functions that are handed it, or a part of it, by a name that is imported.

    Each function is entered once for each of its parameters, in the order in which the code is written.
    """

    def __init__(self, root: Path) -> None:
        self.root, self.entered = root, set[tuple[str, str, int]]()
        self.modules: dict[str, ast.Module | None] = {}

    def follow(self, module: str, name: str, place: int) -> Iterator[str]:
        """The modules that the value is in, one after the other, back in ``module`` after each call."""
        function = self._function(module, name)
        if function is None or (module, name, place) in self.entered or place >= len(function.args.args):
            return
        self.entered.add((module, name, place))
        yield module
        own = function.args.args[place].arg
        calls = [node for node in ast.walk(function) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)]
        for call in sorted(calls, key=lambda each: (each.lineno, each.col_offset)):
            assert isinstance(call.func, ast.Name)
            home = self._home(module, call.func.id)
            for position, argument in enumerate(call.args):
                if home is not None and own in names_in(argument):
                    visited = list(self.follow(home, call.func.id, position))
                    yield from [*visited, module] if visited else []

    def _module(self, module: str) -> ast.Module | None:
        if module not in self.modules:
            path = self.root / (module.replace(".", "/") + ".py")
            path = path if path.is_file() else path.with_suffix("") / "__init__.py"
            self.modules[module] = ast.parse(path.read_text(encoding="utf-8")) if path.is_file() else None
        return self.modules[module]

    def _function(self, module: str, name: str) -> ast.FunctionDef | None:
        tree = self._module(module)
        found = [
            each for each in (tree.body if tree else []) if isinstance(each, ast.FunctionDef) and each.name == name
        ]
        return found[0] if found else None

    def _home(self, module: str, name: str) -> str | None:
        """The module that defines a function which this one calls; None for what is not ours."""
        if self._function(module, name) is not None:
            return module
        tree = self._module(module)
        for node in tree.body if tree else []:
            is_ours = isinstance(node, ast.ImportFrom) and (node.module or "").startswith("vitrail")
            if is_ours and name in {each.asname or each.name for each in node.names}:
                return self._home(node.module, name)
        return None


def names_in(node: ast.AST) -> set[str]:
    return {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}


def layers(tree: Path) -> list[str]:
    """The packages in the order of docs/layers.md."""
    text = (tree / "docs" / "layers.md").read_text(encoding="utf-8").split("## C++")[0]
    return re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE)


def python_functions(text: str) -> Iterator[int]:
    """The lines of each function, its docstring left out."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            docstring = ast.get_docstring(node, clean=False)
            yield (node.end_lineno or node.lineno) - node.lineno + 1 - (docstring.count("\n") + 1 if docstring else 0)


NO_FUNCTION = re.compile(r"(namespace|struct|class|enum|union|using|template|static_assert|extern|typedef|case)\b")


def cpp_functions(text: str) -> Iterator[int]:
    """The lines of each function at the margin, from its head to its closing brace."""
    head = None
    for number, line in enumerate(text.splitlines()):
        if head is None and re.match(r"[A-Za-z:~]", line) and not NO_FUNCTION.match(line):
            head = number
        if head is None or (line.startswith(" ") and not line.endswith(";")):
            continue
        if line.startswith("}") or (number == head and line.endswith("}") and "(" in line):
            yield number - head + 1
            head = None
        elif line.endswith(";") and not any("{" in each for each in text.splitlines()[head : number + 1]):
            head = None


def spread(values: list[int]) -> str:
    """Median, 95th percentile and largest of some counts."""
    ordered = sorted(values)
    return f"{statistics.median_low(ordered)} / {ordered[int(0.95 * (len(ordered) - 1))]} / {ordered[-1]}"


def lines_of(texts: dict[Path, str], paths: list[Path]) -> int:
    return sum(len(texts[path].splitlines()) for path in paths)


def repeated(texts: list[str]) -> int:
    """How many lines lie in a run of ``RUN`` lines of code that stands a second time, imports and comments left out."""
    plain = re.compile(r"^\s*(#|//|import |from |\"\"\"|$|[\])}]+[,;]?$)")
    files = [[line.strip() for line in text.splitlines() if not plain.match(line)] for text in texts]
    places: dict[tuple[str, ...], list[tuple[int, int]]] = {}
    for number, lines in enumerate(files):
        for start in range(len(lines) - RUN + 1):
            places.setdefault(tuple(lines[start : start + RUN]), []).append((number, start))
    twice = {(n, s + i) for found in places.values() if len(found) > 1 for n, s in found for i in range(RUN)}
    return len(twice)


if __name__ == "__main__":
    main()
