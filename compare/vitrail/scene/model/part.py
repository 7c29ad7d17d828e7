"""What every part of a scene is made of: immutable, finite numbers only, each field checked when it is built."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field


class Part(BaseModel):
    """Base of every part of a scene: immutable, finite numbers only, unknown keys refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, strict=False)

    key: ClassVar[str] = ""
    """The key that a file writes this part under, where the key says its type: ``sphere``, ``spot``."""

    @classmethod
    def file_keys(cls) -> dict[str, Any]:
        """Each key that a file may write in this part, with the annotation of its value."""
        return {info.alias or name: info.annotation for name, info in cls.model_fields.items()}

    def entries(self) -> Iterator[tuple[str, Any]]:
        """Each key with its value, in the order in which a file has them; keys at their default are left out."""
        for name, info in type(self).model_fields.items():
            value = getattr(self, name)
            if value != info.default:  # A key that must be given has no default, which equals nothing.
                yield info.alias or name, value


def _triplet(value: Any) -> Any:
    """Spread one number over the three channels, so that ``0.8`` and ``[0.8, 0.8, 0.8]`` are the same colour."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return (value, value, value)
    return value


class _IsColour:
    """Marks the types of colours, so that every key that holds one can be listed."""


IS_COLOUR = _IsColour()


def spread(channel: Any) -> BeforeValidator:
    """Accept one number for three channels; the schema shows both forms."""
    return BeforeValidator(_triplet, json_schema_input_type=channel | tuple[channel, channel, channel])


Finite = Annotated[float, Field(allow_inf_nan=False, strict=True)]
Positive = Annotated[float, Field(gt=0, allow_inf_nan=False, strict=True)]
NotNegative = Annotated[float, Field(ge=0, allow_inf_nan=False, strict=True)]
Vector = tuple[Finite, Finite, Finite]
Colour = Annotated[tuple[NotNegative, NotNegative, NotNegative], spread(NotNegative), IS_COLOUR]
Fraction = Annotated[float, Field(ge=0, le=1, allow_inf_nan=False, strict=True)]
Share = Annotated[tuple[Fraction, Fraction, Fraction], spread(Fraction), IS_COLOUR]
