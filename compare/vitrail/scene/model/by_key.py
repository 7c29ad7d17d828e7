"""A field of one of several types, which a file writes under the key that names the type: ``sphere: {...}``."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar, get_args

from pydantic import GetCoreSchemaHandler, ModelWrapValidatorHandler, ValidationError, model_validator
from pydantic_core import CoreSchema, InitErrorDetails, core_schema

from vitrail.base.fault import Fault
from vitrail.scene.model.part import Part


@dataclass(frozen=True)
class _Written:
    """A value as a file has it, with the key that it stands under."""

    key: str
    value: Any


_NOTHING = _Written("", None)
"""Stands for a value that is not there while the rest of its part is looked at; never kept."""


class ByKey:
    """Annotates the union of the types: which of them a value is follows from its key, and from nothing in it."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        choices: dict[Any, CoreSchema] = {
            kind.key: core_schema.no_info_before_validator_function(_value, handler.generate_schema(kind))
            for kind in get_args(source)
        }
        choices[_NOTHING.key] = core_schema.any_schema()
        return core_schema.tagged_union_schema(choices, discriminator=_key)


def _value(value: Any) -> Any:
    return value.value if isinstance(value, _Written) else value


def _key(value: Any) -> str | None:
    match value:
        case _Written():
            return value.key
        case Part():
            return value.key
        case _:
            return None


class OneByKey(Part):
    """A part that has exactly one value of a union, in the field called ``chosen``.

    A file never writes that field: it writes the key of the type in its place.
    """

    chosen: ClassVar[str]

    @classmethod
    def kinds(cls) -> dict[str, type[Part]]:
        """Key to type."""
        return {kind.key: kind for kind in get_args(cls.model_fields[cls.chosen].annotation)}

    @classmethod
    @abstractmethod
    def miscounted(cls, given: list[str]) -> Fault:
        """What to say of a part with none or several of the keys."""

    @classmethod
    def file_keys(cls) -> dict[str, Any]:
        keys: dict[str, Any] = {}
        for key, annotation in super().file_keys().items():
            keys |= cls.kinds() if key == cls.chosen else {key: annotation}
        return keys

    def entries(self) -> Any:
        for key, value in super().entries():
            yield (value.key, value) if key == self.chosen else (key, value)

    @model_validator(mode="wrap")
    @classmethod
    def _read_by_key(cls, data: Any, handler: ModelWrapValidatorHandler[OneByKey]) -> OneByKey:
        """Put what a file writes under the key of its type into its field; refuse none, and two of them."""
        if not isinstance(data, dict) or isinstance(data.get(cls.chosen), Part):
            return handler(data)
        kinds = cls.kinds()
        given = [key for key in kinds if data.get(key) is not None]
        rest = {key: value for key, value in data.items() if key not in kinds and key != cls.chosen}
        if len(given) == 1 and cls.chosen not in data:
            return handler({**rest, cls.chosen: _Written(given[0], data[given[0]])})

        # Report what is wrong with the parts before what is wrong with their number.
        for value in [_Written(key, data[key]) for key in given] or [_NOTHING]:
            handler({**rest, cls.chosen: value})
        if cls.chosen in data:
            unknown = InitErrorDetails(type="extra_forbidden", loc=(cls.chosen,), input=data[cls.chosen])
            raise ValidationError.from_exception_data(cls.__name__, [unknown])
        raise cls.miscounted(given)
