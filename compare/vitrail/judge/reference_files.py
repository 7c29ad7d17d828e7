"""Read the YAML files of ``references/`` with the strict reader of the scenes: no duplicate keys, no surprises."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from vitrail.scene.yaml_tree import YamlProblem
from vitrail.scene.yaml_tree import read_yaml as read_text


class ReferencesError(Exception):
    """A file of references is missing or cannot be used; the message names the file, what is wrong, and the remedy."""


def read_yaml(path: Path) -> dict[str, Any]:
    """The mapping in a file. Raises ReferencesError."""
    try:
        found, _, problems = read_text(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ReferencesError(f"{path}: cannot be read ({error.strerror}); restore it") from None
    except YamlProblem as problem:
        raise ReferencesError(f"{path}:{problem}") from None
    if problems:
        raise ReferencesError("\n".join(f"{path}:{problem}" for problem in problems))
    if not isinstance(found, dict):
        raise ReferencesError(f"{path}: is not a mapping; write `key: value` lines")
    return found
