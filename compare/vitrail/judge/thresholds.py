"""The tolerance of every metric, from ``references/thresholds.yaml``: a number with its reason, never one in the code.

A project without such a file has the rules that come with Vitrail.

A tolerance may be widened by what the certificate of the translation states for the phenomenon, and by nothing else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import TolerancePart
from vitrail.judge.reference_files import read_yaml

Kind = Literal["relative", "of_patch", "absolute"]
KINDS: tuple[Kind, ...] = ("relative", "of_patch", "absolute")
THRESHOLDS = "thresholds.yaml"


class ThresholdError(Exception):
    """The file of thresholds lacks a rule or has a wrong one; the message names the metric."""


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


@dataclass(frozen=True)
class Thresholds:
    """All rules: those of a phenomenon first, then those of the metric."""

    suite_false_alarm_rate: float
    metrics: Mapping[str, Rule]
    phenomena: Mapping[Phenomenon, Mapping[str, Rule]]
    stored_image: Mapping[str, Rule]

    def rule(self, phenomenon: Phenomenon, metric: str) -> Rule:
        """The rule for a metric; a name with a dot is found by its family. Raises ThresholdError if there is none."""
        family = metric.split(".")[0]
        own = self.phenomena.get(phenomenon, {})
        found = own.get(metric) or own.get(family) or self.metrics.get(metric) or self.metrics.get(family)
        if found is None:
            raise ThresholdError(
                f"references/thresholds.yaml has no rule for the metric `{family}`; add one with a reason"
            )
        return found


def thresholds_of(references: Path) -> Thresholds:
    """The rules of a project, or ours where its folder of references has none. Raises ThresholdError."""
    own = references / THRESHOLDS
    return read_thresholds(own if own.is_file() else own_references() / THRESHOLDS)


def own_references() -> Path:
    """The references that come with Vitrail: those of the repository, or in a wheel those beside the package."""
    package = Path(__file__).resolve().parents[1]
    for folder in (package.parents[1] / "references", package / "references"):
        if (folder / THRESHOLDS).is_file():
            return folder
    raise ThresholdError(f"{package / 'references' / THRESHOLDS}: is missing; install Vitrail again")


def read_thresholds(path: Path) -> Thresholds:
    """Raises ThresholdError for anything that is not a rule."""
    found = read_yaml(path)
    rate = found.get("suite_false_alarm_rate", {}).get("value")
    if not isinstance(rate, float) or not 0 < rate < 1:
        raise ThresholdError(f"{path}: suite_false_alarm_rate.value is {rate!r}; write a rate between 0 and 1")
    own = {name: _rule(path, name, entry) for name, entry in found.get("metrics", {}).items()}
    metrics = {name: _spelt_out(rule, own) for name, rule in own.items()}
    phenomena = {
        Phenomenon(name): {
            metric: _spelt_out(_rule(path, f"{name}.{metric}", entry), own) for metric, entry in rules.items()
        }
        for name, rules in found.get("phenomena", {}).items()
    }
    stored = {name: _rule(path, f"stored_image.{name}", each) for name, each in found.get("stored_image", {}).items()}
    return Thresholds(rate, metrics, phenomena, stored)


def _rule(path: Path, name: str, entry: Mapping[str, Any]) -> Rule:
    """One rule: exactly one kind, an amount above or at 0, a reason."""
    unknown = set(entry) - {*KINDS, "certificate", "reason"}
    kinds = [kind for kind in KINDS if kind in entry]
    if unknown or len(kinds) != 1:
        raise ThresholdError(
            f"{path}: {name} takes one of {', '.join(KINDS)}, `certificate` and `reason`, not {unknown}"
        )
    amount, reason = entry[kinds[0]], str(entry.get("reason", "")).strip()
    if not isinstance(amount, int | float) or not 0 <= amount < float("inf"):
        raise ThresholdError(f"{path}: {name}.{kinds[0]} is {amount!r}; write a number at or above 0")
    if not reason:
        raise ThresholdError(f"{path}: {name} has no reason; say why {amount:g} and not half or twice of it")
    scale = entry.get("certificate")
    return Rule(kinds[0], float(amount), reason, None if scale is None else float(scale))


def _spelt_out(rule: Rule, others: Mapping[str, Rule]) -> Rule:
    """A reason of the form ``as other_metric, and more`` with the other metric's reason in its place."""
    words = rule.reason.removeprefix("as ")
    other = others.get(words.split(",")[0].split(" ")[0]) if words != rule.reason else None
    return rule if other is None else replace(rule, reason=f"{rule.reason}: {other.reason}")
