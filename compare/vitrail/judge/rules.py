"""One rule of ``references/thresholds.yaml``: as the file writes it, and as a number is judged by it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from vitrail.base.fault import Fault
from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import TolerancePart

Kind = Literal["relative", "of_patch", "absolute"]
KINDS: tuple[Kind, ...] = ("relative", "of_patch", "absolute")


@dataclass(frozen=True)
class Rule:
    """How far one metric may be from its ideal; ``certificate`` is what a residual of 1 is worth, as ``kind``."""

    kind: Kind
    amount: float
    reason: str
    certificate: float | None = None

    def part(self, ideal: float, half_edge_m: float) -> TolerancePart:
        """The tolerance in the metric's unit, for an ideal value and a patch."""
        return TolerancePart(source="threshold", amount=self.amount * self.size(ideal, half_edge_m), reason=self.reason)

    def widening(self, residual: float, ideal: float, half_edge_m: float) -> float:
        """What a relative ``residual`` of the translation is worth in the metric's unit."""
        usual = 0.0 if self.kind == "absolute" else 1.0
        worth = usual if self.certificate is None else self.certificate
        return residual * worth * self.size(ideal, half_edge_m)

    def size(self, ideal: float, half_edge_m: float) -> float:
        return {"relative": abs(ideal), "of_patch": half_edge_m, "absolute": 1.0}[self.kind]


# --- as written -----------------------------------------------------------------------------------------------------

Amount = Annotated[float, Field(ge=0, allow_inf_nan=False, strict=True)]


class _Written(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class WrittenRule(_Written):
    """Exactly one kind with its amount, and a reason: words of its own, or those of the metric after ``as``."""

    relative: Amount | None = None
    of_patch: Amount | None = None
    absolute: Amount | None = None
    certificate: Annotated[float, Field(allow_inf_nan=False, strict=True)] | None = None
    same_as: str | None = Field(default=None, alias="as")
    reason: str = ""

    @model_validator(mode="after")
    def _is_one_rule(self) -> Self:
        kinds = self._amounts()
        if len(kinds) != 1:
            what = f"takes one of {', '.join(KINDS)}, and has {' and '.join(kinds) or 'none'}"
            raise Fault(what, "write `certificate`, `reason` and `as` beside it")
        if not self.reason.strip() and self.same_as is None:
            raise Fault("has no reason", f"say why {next(iter(kinds.values())):g} and not half or twice of it")
        return self

    def _amounts(self) -> dict[Kind, float]:
        amounts: dict[Kind, float | None] = dict(zip(KINDS, (self.relative, self.of_patch, self.absolute), strict=True))
        return {kind: amount for kind, amount in amounts.items() if amount is not None}

    def read(self, own: Mapping[str, Rule]) -> Rule:
        """The rule; ``own`` are the rules with reasons of their own. Raises Fault for ``as`` anything else."""
        [(kind, amount)] = self._amounts().items()
        reason = self.reason.strip()
        if self.same_as is not None:
            if self.same_as not in own:
                raise Fault(f"`as: {self.same_as}` names no metric with a reason of its own", "write the reason out")
            reason = f"as {self.same_as}{', ' if reason else ''}{reason}: {own[self.same_as].reason}"
        return Rule(kind, amount, reason, self.certificate)


class FalseAlarmRate(_Written):
    """The chance of a deviation in a run without any, and why that is little enough."""

    value: Annotated[float, Field(gt=0, lt=1, strict=True)]
    reason: str = ""


class ThresholdFile(_Written):
    """The whole of ``thresholds.yaml``."""

    version: Literal[1] = 1
    suite_false_alarm_rate: FalseAlarmRate
    metrics: dict[str, WrittenRule] = {}
    phenomena: dict[Phenomenon, dict[str, WrittenRule]] = {}
    stored_image: dict[str, WrittenRule] = {}


def message_of(error: ValidationError) -> str:
    """The first thing that is wrong, by the name of its rule, and what to do about it."""
    first = error.errors(include_url=False)[0]
    section, *rest = [str(step) for step in first["loc"]]
    name = ".".join(rest if section == "metrics" and rest else [section, *rest])
    return f"{name} {_what(first['type'], first.get('ctx') or {}, first['input'])}"


def _what(kind: str, context: Mapping[str, Any], given: object) -> str:
    if kind == "value_error":
        return str(context["error"])
    if kind == "extra_forbidden":
        return f"is unknown; a rule takes one of {', '.join(KINDS)}, and `certificate`, `reason`, `as`"
    if kind == "missing":
        return "is missing; write it"
    limits = [f"{_WORDS[key]} {value:g}" for key, value in context.items() if key in _WORDS]
    wanted = f"a number {' and '.join(limits)}" if limits else "what belongs there"
    return f"is {given!r}; write {wanted}"


_WORDS = {"ge": "at or above", "gt": "above", "lt": "below", "le": "at or below"}
