"""The tolerance of every metric, from ``references/thresholds.yaml``: a number with its reason, never one in the code.

A project without such a file has the rules that come with Vitrail.

A tolerance may be widened by what the certificate of the translation states for the phenomenon, and by nothing else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from pydantic import ValidationError

from vitrail.base.fault import Fault
from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.reference_files import read_yaml
from vitrail.judge.rules import Rule, ThresholdFile, message_of

THRESHOLDS = "thresholds.yaml"


class ThresholdError(Exception):
    """The file of thresholds lacks a rule or has a wrong one; the message names the metric."""


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
    try:
        written = ThresholdFile.model_validate(read_yaml(path))
        own = {name: rule.read({}) for name, rule in written.metrics.items() if rule.same_as is None}
        return Thresholds(
            written.suite_false_alarm_rate.value,
            {name: rule.read(own) for name, rule in written.metrics.items()},
            {
                name: {metric: rule.read(own) for metric, rule in each.items()}
                for name, each in written.phenomena.items()
            },
            {name: rule.read(own) for name, rule in written.stored_image.items()},
        )
    except ValidationError as error:
        raise ThresholdError(f"{path}: {message_of(error)}") from None
    except Fault as fault:
        raise ThresholdError(f"{path}: {fault}") from None
