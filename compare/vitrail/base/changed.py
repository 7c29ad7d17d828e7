"""A copy of a value with some fields replaced, as sound as if it had been read."""

from __future__ import annotations

from typing import TypeVar

from pydantic import BaseModel

Model = TypeVar("Model", bound=BaseModel)


def changed(part: Model, **fields: object) -> Model:
    """``part`` with some fields replaced by name; every check of its type runs on the result.

    Raises ValidationError for a value that the type refuses, and TypeError for a field that does not exist; pydantic's
    own ``model_copy`` takes both without a word. Parts that stay are taken as they are and not read again.
    """
    _refuse_unknown(part, fields)
    kept = {name: getattr(part, name) for name in type(part).model_fields if name in part.model_fields_set}
    return type(part).model_validate({**kept, **fields}, by_name=True, by_alias=False)


def unchecked(part: Model, **fields: object) -> Model:
    """``changed`` without the rules of the type: for a defect that is put in on purpose, or a value beyond what a file
    may say. Raises TypeError for a field that does not exist.
    """
    _refuse_unknown(part, fields)
    kept = {name: getattr(part, name) for name in type(part).model_fields}
    return type(part).model_construct(part.model_fields_set | set(fields), **{**kept, **fields})


def _refuse_unknown(part: BaseModel, fields: dict[str, object]) -> None:
    unknown = sorted(set(fields) - set(type(part).model_fields))
    if unknown:
        raise TypeError(f"{type(part).__name__} has no {', '.join(unknown)}")
