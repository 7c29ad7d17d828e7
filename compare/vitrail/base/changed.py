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
