"""A copy of a value with some fields replaced, as sound as if it had been read."""

from __future__ import annotations

from typing import TypeVar

from pydantic import BaseModel

Model = TypeVar("Model", bound=BaseModel)


def changed(part: Model, **fields: object) -> Model:
    """``part`` with some fields replaced by name; every check of its type runs on the result.

    Unlike ``model_copy(update=...)`` a misspelt field, or a value that the type refuses, raises ValidationError. Parts
    that stay are taken as they are and not read again.
    """
    names = type(part).model_fields
    kept = {name: getattr(part, name) for name in names if name in part.model_fields_set}
    return type(part).model_validate({**kept, **fields}, by_name=True, by_alias=False)


def unchecked(part: Model, **fields: object) -> Model:
    """``changed`` without the rules of the type, for a value that is meant to break them: a defect put in on purpose.

    A field that does not exist still raises, with TypeError.
    """
    unknown = set(fields) - set(type(part).model_fields)
    if unknown:
        raise TypeError(f"{type(part).__name__} has no {', '.join(sorted(unknown))}")
    kept = {name: getattr(part, name) for name in type(part).model_fields}
    return type(part).model_construct(part.model_fields_set | set(fields), **{**kept, **fields})
