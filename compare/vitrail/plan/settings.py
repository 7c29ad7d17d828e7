"""The settings of a rendering as types: what each may be, and how it is read from what a user typed.

A number is never read by way of a float: a seed has 64 bits, of which a float keeps 53.
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal, InvalidOperation
from enum import StrEnum
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError
from pydantic_core import ErrorDetails

from vitrail.base.fault import Fault
from vitrail.base.suggestion import nearest, suggestion


class Quality(StrEnum):
    """How much work a rendering may do, where no setting says it."""

    DRAFT = "draft"
    NORMAL = "normal"
    REFERENCE = "reference"


class Solver(StrEnum):
    """How the tracer finds the light of caustics."""

    AUTO = "auto"
    PHOTON_MAP = "photon_map"
    LIGHT_BINS = "light_bins"
    BEAMS = "beams"


class ReferenceMode(StrEnum):
    """Into how many runs POV-Ray's picture is split: one, one per channel, or one per band."""

    AUTO = "auto"
    NATIVE = "native"
    CHANNELS = "channels"
    SLICES = "slices"


MOST_DIGITS = 40
"""A whole number with more digits than this is refused unread; the largest setting has 20."""


def _exact(value: object) -> object:
    """Text or a float as the whole number that it is, to the last digit; 1e6 is one too. Anything else stays."""
    if not isinstance(value, (str, float)):
        return value
    try:
        number = Decimal(str(value).strip())
    except InvalidOperation:
        return value
    if not number.is_finite() or number.adjusted() >= MOST_DIGITS or number != number.to_integral_value():
        return value
    return int(number)


Whole = Annotated[int, BeforeValidator(_exact), Field(strict=True)]
"""A whole number, typed in any form, and read without loss."""


class Settings(BaseModel):
    """Knobs of a rendering, the same for both engines; ``samples`` are per pixel, ``photons`` per scene.

    The largest numbers are those that the tracer reads. With ``gather_disc`` the tracer's caustics are means over the
    disc of ``gather_radius_m`` by any solver, as POV-Ray's always are; without it only by ``photon_map``.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    quality: Quality
    samples: Annotated[Whole, Field(ge=1, le=2**20)]
    photons: Annotated[Whole, Field(ge=0, le=2**40)]
    gather_radius_m: Annotated[float, Field(gt=0, allow_inf_nan=False)]
    seed: Annotated[Whole, Field(ge=0, le=2**64 - 1)]
    rough_samples: Annotated[Whole, Field(ge=1, le=10**6)]
    final_gather_rays: Annotated[Whole, Field(ge=0, le=10**6)]
    memory_limit_mb: Annotated[Whole, Field(ge=1, le=2**53)]
    solver: Solver
    branch_share: Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)]
    reference_mode: ReferenceMode
    gather_disc: bool = False

    def as_record(self) -> dict[str, Any]:
        """Name to value, as JSON has it; without ``gather_disc`` where it is off, as in records from before it."""
        return self.model_dump(mode="json", exclude=None if self.gather_disc else {"gather_disc"})


def setting_names() -> tuple[str, ...]:
    """The settings that a user can replace, in the order in which records hold them."""
    return tuple(Settings.model_fields)


def read_settings(values: Mapping[str, object]) -> Settings:
    """Settings from typed text or from numbers. Raises the Fault of the first value that cannot be used."""
    try:
        return Settings.model_validate(values)
    except ValidationError as error:
        raise _fault(error.errors(include_url=False)[0]) from None


def _fault(error: ErrorDetails) -> Fault:
    """What is wrong with one value, and what it may be."""
    key, kind = str(error["loc"][0]), error["type"]
    if kind == "extra_forbidden":
        return Fault("is no setting", suggestion(key, setting_names(), "setting"), (key,))
    if isinstance(kinds := Settings.model_fields[key].annotation, type) and issubclass(kinds, StrEnum):
        choices = list(kinds)
        close = nearest(str(error["input"]), choices)
        what = f"is not one of {', '.join(choices)}"
        return Fault(what, f"did you mean `{close}`?" if close else "choose one of them", (key,))
    if key == "branch_share":
        return Fault("is not a share of a look", "write a number from 0 to 1", (key,))
    if kinds is bool:
        return Fault("is neither true nor false", "write true or false", (key,))
    if kinds is float:
        what = "is not above 0" if kind == "greater_than" else "is not a length"
        return Fault(what, "write a length in metres above 0", (key,))
    least, most = (_limit(key, bound) for bound in ("ge", "le"))
    if kind == "greater_than_equal":
        return Fault(f"is below {least}", f"write a whole number from {least} to {most}", (key,))
    if kind == "less_than_equal":
        return Fault(f"is above {most}", f"write a whole number from {least} to {most}", (key,))
    return Fault("is not a whole number", f"write one from {least} to {most}", (key,))


def _limit(key: str, bound: str) -> int:
    """The least (``ge``) or the largest (``le``) value of a whole number; pydantic's own message rounds it."""
    found = (getattr(each, bound, None) for each in Settings.model_fields[key].metadata)
    return next(limit for limit in found if limit is not None)
