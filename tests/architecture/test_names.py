"""A name that the package defines is used somewhere: dead code is read, moved and tested for nothing."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tests.architecture.source_tree import PACKAGE, ROOT, project_files

NAMED_BY_OTHERS = re.compile(r"__\w+__|pytest_\w+")
"""Names that Python or pytest calls."""

CALLED_FROM_OUTSIDE = {
    "list_commands": "click lists the verbs by it",
    "reportinfo": "pytest names an item by it",
    "check_text": "the whole check without a file, which tests and examples in documents go through",
    "checker_index": "the contract of patterns, which both engines are held to",
    "kind_of": "the published files of studies are matched to their schemas by it",
    "point_on_plane": "the inverse of the projection, which the projection is held to",
}
"""Names that nothing of the product mentions, each with the reason why it stays."""


def definitions(path: Path) -> Iterator[tuple[int, str]]:
    """Line and name of every function, class, method and constant at the top of a module or of its classes."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in [*tree.body, *(inner for each in tree.body if isinstance(each, ast.ClassDef) for inner in each.body)]:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.decorator_list:
            yield node.lineno, node.name
        elif isinstance(node, ast.Assign) and node in tree.body:
            yield from ((node.lineno, target.id) for target in node.targets if isinstance(target, ast.Name))


def words(path: Path) -> Iterator[str]:
    return iter(re.findall(r"\w+", path.read_text(encoding="utf-8", errors="ignore")))


def test_every_name_of_the_package_is_used() -> None:
    """Also by templates, JavaScript and set-up files; a mention in a test alone does not count."""
    product = [ROOT / path for path in project_files() if path.parts[0] in {"compare", "tools", "pyproject.toml"}]
    used = Counter(
        word
        for path in product
        if path.suffix in {".py", ".html", ".md", ".svg", ".js", ".toml"}
        for word in words(path)
    )
    dead = [
        f"{path.relative_to(ROOT)}:{line}: {name}"
        for path in sorted(PACKAGE.rglob("*.py"))
        for line, name in definitions(path)
        if used[name] < 2 and not NAMED_BY_OTHERS.fullmatch(name) and name not in CALLED_FROM_OUTSIDE
    ]
    assert not dead, "nothing of the product uses these names; remove them:\n" + "\n".join(dead)


def test_the_list_of_exceptions_is_true() -> None:
    known = {name for path in PACKAGE.rglob("*.py") for _, name in definitions(path)}
    assert set(CALLED_FROM_OUTSIDE) <= known, f"gone: {sorted(set(CALLED_FROM_OUTSIDE) - known)}"
