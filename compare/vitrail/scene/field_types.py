"""What the types of the language say about a place in a file: the keys it may have, and a value that would be right."""

from __future__ import annotations

import types
import typing
from collections.abc import Iterator
from functools import cache
from typing import Any

from vitrail.scene.model import Part
from vitrail.scene.yaml_tree import Path


def known_keys(path: Path, data: Any, top: type[Part]) -> list[str]:
    """The keys that the mapping at ``path`` may have, as written in a file."""
    keys: list[str] = []
    for model in _models_at(path, top):
        keys += model.file_keys()
    return list(dict.fromkeys(keys))


def _models_at(path: Path, top: type[Part]) -> list[type[Part]]:
    """The models whose fields the mapping at ``path`` is read as."""
    current: list[Any] = [top]
    for step in path:
        following: list[Any] = []
        for annotation in current:
            following += _below(annotation, step)
        current = [leaf for annotation in following for leaf in _leaves(annotation)]
    return [each for each in current if isinstance(each, type) and issubclass(each, Part)]


def _below(annotation: Any, step: str | int) -> list[Any]:
    """The annotations one step further down."""
    if isinstance(annotation, type) and issubclass(annotation, Part):
        return [value for key, value in annotation.file_keys().items() if step == key]
    arguments = typing.get_args(annotation)
    if typing.get_origin(annotation) is dict:
        return [arguments[1]]
    if typing.get_origin(annotation) is tuple and isinstance(step, int):
        return [arguments[0] if arguments[-1] is Ellipsis else arguments[min(step, len(arguments) - 1)]]
    return []


def _leaves(annotation: Any) -> Iterator[Any]:
    """The alternatives of an annotation, without Annotated, Optional and unions around them."""
    origin = typing.get_origin(annotation)
    if origin is typing.Annotated:
        yield from _leaves(typing.get_args(annotation)[0])
    elif origin in (typing.Union, types.UnionType):
        for argument in typing.get_args(annotation):
            yield from _leaves(argument)
    else:
        yield annotation


_EXAMPLES = {
    "vitrail": "1",
    "camera": "{position: [0, 2, 5], look_at: [0, 0, 0], fov_deg: 35}",
    "image": "{width: 640, height: 480}",
    "materials": "{white: {diffuse: 0.8}}",
    "objects": "[{name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: white}]",
    "lights": "[{name: sun, directional: {direction: [0, -1, 0], irradiance: 3}}]",
    "normal": "[0, 1, 0]",
    "direction": "[0, -1, 0]",
    "patch": "{center: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1]}",
    "phenomenon": "caustic",
    "colors": "[0.1, 0.9]",
    "profile": "[[0, 0], [1, 0], [0, 1]]",
}


def example_at(path: Path, data: Any, top: type[Part]) -> str:
    """A value that would be right there."""
    name = next((step for step in reversed(path) if isinstance(step, str)), "")
    if path and isinstance(path[-1], str) and name in _EXAMPLES:
        return _EXAMPLES[name]
    leaves = [leaf for model in _models_at(_holder(path), top) for leaf in _field_leaves(model, name)]
    if any(typing.get_origin(leaf) is tuple for leaf in leaves) and isinstance(path[-1], str):
        return "three numbers, as in [1, 0.5, 0]"
    if bool in leaves:
        return "true"
    if int in leaves:
        return "a whole number, as in 64"
    if str in leaves:
        return "a name"
    if any(isinstance(leaf, type) and issubclass(leaf, Part) for leaf in leaves):
        keys = known_keys(path, data, top)
        return "{" + ", ".join(f"{key}: ..." for key in keys[:4]) + "}"
    return "a number, as in 0.5"


def _holder(path: Path) -> Path:
    """The path of the mapping that holds the last key of ``path``."""
    last = max((index for index, step in enumerate(path) if isinstance(step, str)), default=0)
    return path[:last]


def _field_leaves(model: type[Part], name: str) -> list[Any]:
    return [leaf for key, annotation in model.file_keys().items() if name == key for leaf in _leaves(annotation)]


@cache
def part_types(top: type[Part]) -> frozenset[type[Part]]:
    """Every type of part that a value of ``top`` may hold, itself included."""
    found, waiting = {top}, [top]
    while waiting:
        for annotation in waiting.pop().file_keys().values():
            new = set(_parts_in(annotation)) - found
            found |= new
            waiting += new
    return frozenset(found)


def _parts_in(annotation: Any) -> Iterator[type[Part]]:
    for leaf in _leaves(annotation):
        if isinstance(leaf, type) and issubclass(leaf, Part):
            yield leaf
        else:
            for inner in typing.get_args(leaf):
                yield from _parts_in(inner)
