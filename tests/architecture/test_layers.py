"""Nothing knows a folder below it: docs/layers.md against every import and include."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.architecture.source_tree import (
    PACKAGE,
    TRACER,
    allowed,
    cpp_files,
    find_cycle,
    imported_names,
    included_names,
    own_header,
    python_modules,
    quoted,
    table,
)

PYTHON = "Python, `compare/vitrail/`"
CPP = "C++, `tracer/`"


def test_the_tables_list_folders_in_the_order_data_flows() -> None:
    for heading in (PYTHON, CPP):
        rules = allowed(heading)
        above: set[str] = set()
        for folder, may_use in rules.items():
            assert may_use <= above | {folder}, (
                f"{folder} may use {may_use - above - {folder}}, which is listed below it"
            )
            above.add(folder)


def test_every_folder_has_its_row() -> None:
    packages = {path.name for path in PACKAGE.iterdir() if path.is_dir() and any(path.glob("*.py"))}
    assert packages <= set(allowed(PYTHON))
    folders = {path.relative_to(TRACER).parts[0] for path in cpp_files()}
    assert folders <= set(allowed(CPP))


def test_python_imports_keep_to_the_table() -> None:
    rules = allowed(PYTHON)
    broken = []
    for module, path in python_modules().items():
        layer = module.split(".")[1] if "." in module else None
        for line, name in imported_names(path):
            parts = name.split(".")
            if parts[0] != "vitrail" or len(parts) < 2 or parts[1] not in rules:
                continue
            if layer is None or parts[1] not in rules[layer]:
                broken.append(f"{path.relative_to(PACKAGE.parent)}:{line}: {layer} may not import {name}")
    assert not broken, "\n".join(sorted(set(broken)))


def test_cpp_includes_keep_to_the_table() -> None:
    rules = allowed(CPP)
    broken = []
    for path in cpp_files():
        layer = path.relative_to(TRACER).parts[0]
        for name in included_names(path):
            header = own_header(name)
            if header is not None and header.parts[0] not in rules[layer]:
                broken.append(f"{path.relative_to(TRACER.parent)}: {layer} may not include {name}")
    assert not broken, "\n".join(broken)


def test_link_lines_keep_to_the_table() -> None:
    """Each folder is a library whose link line is its row, so that what is not listed does not link either."""
    rules = allowed(CPP)
    broken = []
    for path in sorted(TRACER.glob("*/CMakeLists.txt")):
        for call in re.findall(r"vitrail_library\(([^)]*)\)", path.read_text(encoding="utf-8")):
            layer, *linked = call.split()
            ours = {name.removeprefix("vitrail_") for name in linked if name.startswith("vitrail_")}
            if layer != path.parent.name or not ours <= rules[layer]:
                broken.append(f"{path.relative_to(TRACER.parent)}: {layer} links {sorted(ours - rules[layer])}")
    assert not broken, "\n".join(broken)


def test_quoted_includes_are_ours_and_exist() -> None:
    """A quoted include that resolves to nothing under tracer/ would slip past the tables."""
    missing = []
    for path in cpp_files():
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith('#include "') and own_header(name := line.split('"')[1]) is None:
                missing.append(f"{path.relative_to(TRACER.parent)}: {name}: write it from tracer/ on")
    assert not missing, "\n".join(missing)


def test_no_cycle_between_python_files() -> None:
    modules = python_modules()
    edges = {
        module: {name for _, name in imported_names(path) if name in modules and name != module}
        for module, path in modules.items()
    }
    # A package's __init__ that only documents takes no part: importing a.b.c from a.b imports nothing twice.
    cycle = find_cycle(edges)
    assert cycle is None, " -> ".join(cycle or [])


def test_no_cycle_between_cpp_files() -> None:
    edges: dict[str, set[str]] = {}
    for path in cpp_files():
        headers = {own_header(name) for name in included_names(path)}
        edges[str(path.relative_to(TRACER))] = {str(header) for header in headers if header}
    cycle = find_cycle(edges)
    assert cycle is None, " -> ".join(cycle or [])


THIRD_PARTIES = [
    (library, language, tuple(quoted(rooms)))
    for names, language, rooms in table("Third parties")
    for library in quoted(names)
]
EACH_THIRD_PARTY = pytest.mark.parametrize(
    ("library", "language", "rooms"), THIRD_PARTIES, ids=[row[0] for row in THIRD_PARTIES]
)


def users_of(library: str, language: str) -> list[Path]:
    """The files that import or include a library, relative to their tree; ``Imf*`` names headers by how they begin."""
    if language == "Python":
        files, top, names = list(python_modules().values()), PACKAGE, lambda path: [n for _, n in imported_names(path)]
    else:
        files, top, names = cpp_files(), TRACER, included_names
    own = re.compile(re.escape(library).replace(r"\*", r"\w*") + r"(?:[./].*)?")
    return [path.relative_to(top) for path in files if any(own.fullmatch(name) for name in names(path))]


@EACH_THIRD_PARTY
def test_a_third_party_stays_in_its_room(library: str, language: str, rooms: tuple[str, ...]) -> None:
    strays = [str(path) for path in users_of(library, language) if not str(path).startswith(rooms)]
    assert not strays, f"{library} belongs in {' or '.join(rooms)}, but is used in {', '.join(strays)}"


@EACH_THIRD_PARTY
def test_a_third_party_is_used_at_all(library: str, language: str, rooms: tuple[str, ...]) -> None:
    assert users_of(library, language), f"no file uses {library}; drop its row from docs/layers.md"
