"""What a file may be called, how long it may be, and what it may not mention."""

from __future__ import annotations

import ast
import re
from pathlib import Path

from tests.architecture.source_tree import ROOT, project_files

VAGUE_NAMES = {"util", "utils", "common", "helper", "helpers", "misc", "stuff", "tools_lib"}

LONGEST_FILE = 280
"""Lines. Files aim at 260."""

LONGEST_FUNCTION = 60
"""Lines. Functions aim at 40; the rest is room for one long signature or one exhaustive match."""

MACHINE_PATH = re.compile(r"(?<![\w.])/(?:root|home/\w+|work|tmp/\w+)(?:/[\w.-]+)+")
"""An absolute path of one machine; a scene, a test or a page that names one works nowhere else."""


def sources(*suffixes: str) -> list[Path]:
    return [path for path in project_files() if path.suffix in suffixes]


def test_no_file_has_a_vague_name() -> None:
    vague = [path for path in project_files() if {part.split(".")[0].lower() for part in path.parts} & VAGUE_NAMES]
    assert not vague, f"name a file after the one thing it explains: {vague}"


def test_files_are_short_enough_to_read() -> None:
    long = []
    for path in sources(".py", ".h", ".cc", ".cpp", ".sh"):
        lines = len((ROOT / path).read_text(encoding="utf-8").splitlines())
        if lines > LONGEST_FILE:
            long.append(f"{path}: {lines} lines")
    assert not long, "split by thing explained:\n" + "\n".join(long)


def test_python_functions_are_short_enough_to_read() -> None:
    long = []
    for path in sources(".py"):
        for node in ast.walk(ast.parse((ROOT / path).read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                lines = (node.end_lineno or node.lineno) - node.lineno + 1
                if lines > LONGEST_FUNCTION:
                    long.append(f"{path}:{node.lineno}: {node.name}: {lines} lines")
    assert not long, "\n".join(long)


def test_every_python_module_says_what_it_is_about() -> None:
    silent = []
    for path in sources(".py"):
        text = (ROOT / path).read_text(encoding="utf-8")
        if path.parts[0] == "compare" and text.strip() and not ast.get_docstring(ast.parse(text)):
            silent.append(path)
    assert not silent, f"open each with a docstring: {silent}"


def test_every_cpp_header_says_what_it_is_about() -> None:
    """A header opens with a comment, before or after its guard."""
    silent = [
        path
        for path in sources(".h")
        if path.parts[0] == "tracer"
        and not re.match(r"(\s|#pragma once)*//", (ROOT / path).read_text(encoding="utf-8"))
    ]
    assert not silent, f"open each with a comment: {silent}"


def test_nothing_depends_on_one_machine() -> None:
    found = []
    for path in project_files():
        if path.suffix in {".png", ".exr", ".ply", ".ico"}:
            continue
        text = (ROOT / path).read_text(encoding="utf-8", errors="replace")
        found += [f"{path}: {match.group()}" for match in MACHINE_PATH.finditer(text)]
    assert not found, "\n".join(found)


CONFLICT = re.compile(r"^(<{7} |={7}$|>{7} )", re.MULTILINE)
"""What a merge leaves behind where it could not decide."""


def test_no_merge_conflict_was_committed() -> None:
    found = []
    for path in project_files():
        text = (ROOT / path).read_bytes().decode("utf-8", errors="ignore")
        if path.suffix not in {".png", ".exr", ".ply"} and CONFLICT.search(text):
            found.append(str(path))
    assert not found, f"resolve the conflict in {found}"
