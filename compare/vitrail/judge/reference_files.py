"""Read the YAML files of ``references/`` with the strict reader of the scenes: no duplicate keys, no surprises."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

from vitrail.scene.yaml_tree import YamlProblem
from vitrail.scene.yaml_tree import read_yaml as read_text


class ReferencesError(Exception):
    """A file of references is missing or cannot be used; the message names the file, what is wrong, and the remedy."""


def read_yaml(path: Path) -> dict[str, Any]:
    """The mapping in a file; not to be changed, because a text that was read before is not read again.

    Raises ReferencesError.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise ReferencesError(f"{path}: cannot be read ({error.strerror}); restore it") from None
    return _mapping(path, text)


@lru_cache(maxsize=64)
def _mapping(path: Path, text: str) -> dict[str, Any]:
    """Every scene of a run asks for the same closed forms, and to read them strictly takes a quarter of a second."""
    try:
        found, _, problems = read_text(text)
    except YamlProblem as problem:
        raise ReferencesError(f"{path}:{problem}") from None
    if problems:
        raise ReferencesError("\n".join(f"{path}:{problem}" for problem in problems))
    if not isinstance(found, dict):
        raise ReferencesError(f"{path}: is not a mapping; write `key: value` lines")
    return found
