"""Where the scene language holds colours, read off its types: a key that is forgotten nowhere."""

from __future__ import annotations

import typing
from collections.abc import Iterator
from functools import cache
from typing import Any

from vitrail.base.colour import Triplet
from vitrail.scene.field_types import part_types
from vitrail.scene.model import Part, Scene
from vitrail.scene.model.part import IS_COLOUR


@cache
def colour_keys() -> frozenset[str]:
    """The keys whose value is a colour: one number, or three for red, green and blue."""
    return frozenset(key for part in part_types(Scene) for key, hint in _hints(part).items() if _is_colour(hint))


def colours_of(part: Part) -> Iterator[Triplet]:
    """All colours in a part and in the parts of it."""
    for name, hint in _hints(type(part)).items():
        yield from _colours(getattr(part, name), _holds_colours(hint))


def _colours(value: object, holds_colours: bool) -> Iterator[Triplet]:
    match value:
        case Part():
            yield from colours_of(value)
        case dict():
            for inner in value.values():
                yield from _colours(inner, holds_colours)
        case (float() | int(), float() | int(), float() | int()) if holds_colours:
            yield (value[0], value[1], value[2])
        case tuple():
            for inner in value:
                yield from _colours(inner, holds_colours)


@cache
def _hints(part: type[Part]) -> dict[str, Any]:
    """Field to annotation, with everything that is annotated."""
    hints = typing.get_type_hints(part, include_extras=True)
    return {name: hints[name] for name in part.model_fields}


def _is_colour(hint: Any) -> bool:
    """Whether a value may be a colour itself; a tuple of colours is none."""
    if typing.get_origin(hint) is tuple:
        return False
    return IS_COLOUR in getattr(hint, "__metadata__", ()) or any(_is_colour(each) for each in typing.get_args(hint))


def _holds_colours(hint: Any) -> bool:
    return IS_COLOUR in getattr(hint, "__metadata__", ()) or any(_holds_colours(each) for each in typing.get_args(hint))
