"""What a user installs is what the product imports: a dependency of the tests alone belongs to the tests."""

from __future__ import annotations

import re
import tomllib
from importlib.metadata import packages_distributions

from tests.architecture.source_tree import PACKAGE, ROOT, imported_names


def test_the_product_imports_every_runtime_dependency() -> None:
    declared = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["dependencies"]
    modules = {name.split(".")[0] for path in PACKAGE.rglob("*.py") for _, name in imported_names(path)}
    used = {_plain(package) for module in modules for package in packages_distributions().get(module, ())}
    idle = [name for name in declared if _plain(re.split(r"[<>=!~ ;\[]", name)[0]) not in used]
    assert not idle, f"no product file imports {', '.join(idle)}; move it to an extra of pyproject.toml"


def _plain(name: str) -> str:
    """A name of a distribution, as package indexes compare it [PEP 503]."""
    return re.sub(r"[-_.]+", "-", name).lower()
