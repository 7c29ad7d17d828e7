"""Scene file to ``Scene``: read, build the types, and name every error with its place."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from vitrail.scene.diagnostic import Diagnostic, SceneErrors
from vitrail.scene.field_errors import field_diagnostics
from vitrail.scene.model import Scene
from vitrail.scene.names import name_diagnostics
from vitrail.scene.yaml_tree import MAX_BYTES, Places, YamlProblem, read_yaml


@dataclass(frozen=True)
class Loaded:
    """A scene with the place of each of its values, and the file (or name) it came from."""

    scene: Scene
    places: Places
    path: Path

    def at(self, what: str, remedy: str, *path: str | int) -> Diagnostic:
        """An error about the value at ``path``."""
        return Diagnostic(str(self.path), *self.places.of(*path), what, remedy)


def load(path: str | Path) -> Loaded:
    """Read a scene file. Raises SceneErrors with every error found, also when the file cannot be read."""
    path = Path(path)
    return load_text(_text_of(path), path)


def load_text(text: str, name: str | Path = "scene.yaml") -> Loaded:
    """Read a scene from text; ``name`` stands for the file in messages, and files it names are sought beside it."""
    file = str(name)
    try:
        data, places, problems = read_yaml(text)
    except YamlProblem as problem:
        raise SceneErrors([_diagnostic(problem, file)]) from None
    found = [_diagnostic(problem, file) for problem in problems]
    if not isinstance(data, dict):
        what = f"a scene is a mapping of keys, this file is {_kind(data)}"
        raise SceneErrors([*found, Diagnostic(file, 1, 1, what, "start with `vitrail: 1`")])
    found += name_diagnostics(data, places, file)
    found += [_without_value(path, places, file) for path in _voids(data, ())]
    try:
        scene = Scene.model_validate(data)
    except ValidationError as error:
        # A value that could not be read at all has been reported; what its stand-in causes is no news.
        known = {(each.line, each.col) for each in found}
        fields = field_diagnostics(error, data, Scene, places, file)
        raise SceneErrors([*found, *(each for each in fields if (each.line, each.col) not in known)]) from None
    if found:
        raise SceneErrors(found)
    return Loaded(scene, places, Path(name))


def _text_of(path: Path) -> str:
    """The text of a file, or SceneErrors that says why there is none."""
    try:
        if path.is_file() and path.stat().st_size > MAX_BYTES:
            what = f"the file is larger than {MAX_BYTES // 2**20} MiB"
            raise SceneErrors([Diagnostic(str(path), 1, 1, what, "put large geometry into a mesh file")])
        raw = path.read_bytes()
    except FileNotFoundError:
        raise SceneErrors([Diagnostic(str(path), 1, 1, "there is no such file", "check the path")]) from None
    except IsADirectoryError:
        raise SceneErrors([Diagnostic(str(path), 1, 1, "this is a folder", "name a scene file inside it")]) from None
    except OSError as error:
        what = f"the file cannot be read ({error.strerror or error})"
        raise SceneErrors([Diagnostic(str(path), 1, 1, what, "check the path and its permissions")]) from None
    return _decoded(raw, path)


def _decoded(raw: bytes, path: Path) -> str:
    """UTF-8 text without control characters; a binary file is refused where it stops being text."""
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line, col = _line_col(raw[: error.start].decode("latin-1"))
        what = f"byte 0x{raw[error.start]:02x} is not UTF-8 text"
        raise SceneErrors([Diagnostic(str(path), line, col, what, "save the scene as UTF-8 text")]) from None
    for index, character in enumerate(text):
        if character < " " and character not in "\t\r\n" or character == "\x7f":
            line, col = _line_col(text[:index])
            what = f"control character 0x{ord(character):02x}"
            raise SceneErrors([Diagnostic(str(path), line, col, what, "save the scene as plain text")])
    return text


def _line_col(before: str) -> tuple[int, int]:
    return (before.count("\n") + 1, len(before) - (before.rfind("\n") + 1) + 1)


def _diagnostic(problem: YamlProblem, file: str) -> Diagnostic:
    return Diagnostic(file, problem.line, problem.col, problem.what, problem.remedy)


def _voids(value: Any, path: tuple[str | int, ...]) -> Iterator[tuple[str | int, ...]]:
    """The path of every key or entry that was given no value."""
    if value is None:
        yield path
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield from _voids(inner, (*path, key))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from _voids(inner, (*path, index))


def _without_value(path: tuple[str | int, ...], places: Places, file: str) -> Diagnostic:
    name = f"`{path[-1]}`" if isinstance(path[-1], str) else "this entry"
    remedy = "put a space after its colon" if ":" in name else "give it one, or remove it"
    return Diagnostic(file, *places.of_key(*path), f"{name} has no value", remedy)


def _kind(data: Any) -> str:
    match data:
        case list():
            return "a list"
        case str():
            return "text"
        case None:
            return "empty"
        case _:
            return "a single value"
