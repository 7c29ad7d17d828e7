"""Scene files and their tests, as pytest sees them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from vitrail.check.check import check_file
from vitrail.commands.comparison_sentence import sentence
from vitrail.judge.comparison import ObservationResult, Verdict
from vitrail.judge.records import GlobalMetric, SceneResult, Status
from vitrail.judge.reference_files import ReferencesError
from vitrail.judge.thresholds import ThresholdError
from vitrail.pytest_plugin.session import of_session


class SceneFailure(Exception):
    """A test of a scene failed; the message is for a person."""


class SceneFile(pytest.File):
    """One scene; its errors are errors of collection, each with its place."""

    is_remarked = False

    def collect(self) -> Iterator[pytest.Item]:
        self.checked = check_file(self.path)
        if not self.checked.is_valid:
            raise self.CollectError("\n".join(str(each) for each in self.checked.errors))
        scene = self.checked.scene_or_raise()
        if not scene.scene.observe:
            raise self.CollectError(f"{self.path}: the scene observes nothing; add an `observe` entry")
        for index, observation in enumerate(scene.scene.observe):
            line = scene.places.of("observe", index)[0]
            yield ObservationTest.from_parent(self, name=observation.name, line=line)
        yield WholeImageTest.from_parent(self, name="whole_image", line=1)

    def result(self) -> SceneResult:
        """The judged scene; raises SceneFailure when it did not come that far."""
        try:
            found = of_session(self.config).result(self.checked, self.path)
        except (ReferencesError, ThresholdError) as error:
            raise SceneFailure(str(error)) from None
        if found.status is not Status.JUDGED:
            raise SceneFailure(f"{found.status.value}: {found.message}")
        self._remark(found)
        return found

    def _remark(self, found: SceneResult) -> None:
        """Say once what a reader must know of a scene that is judged: a reference by another version, for example."""
        if not self.is_remarked:
            self.is_remarked = True
            for warning in found.warnings:
                self.warn(pytest.PytestWarning(warning))


class SceneTest(pytest.Item):
    """A test of a scene: it knows its line and says what failed without a traceback."""

    def __init__(self, *, line: int, **rest: Any) -> None:
        super().__init__(**rest)
        self.line = line

    @property
    def result(self) -> SceneResult:
        assert isinstance(self.parent, SceneFile)
        return self.parent.result()

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, self.line - 1, f"{self.path.stem}.{self.name}"

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, SceneFailure):
            return f"{self.path}:{self.line}: {excinfo.value}"
        return super().repr_failure(excinfo, style)


class ObservationTest(SceneTest):
    """One observation: it passes when every number agrees."""

    def runtest(self) -> None:
        scene = self.result
        found = next(each for each in scene.observations if each.name == self.name)
        self.user_properties.append(("statement", found.statement))
        self.user_properties += [(f"{each.pair.value} {each.metric}", each.value) for each in found.comparisons]
        if not found.comparisons:
            raise SceneFailure("there is nothing to hold it against: no closed form, no stored image, no POV-Ray")
        if found.verdict is not Verdict.AGREES:
            raise SceneFailure(told(found, scene))


class WholeImageTest(SceneTest):
    """The whole picture against its stored image; without one there is nothing that could fail."""

    def runtest(self) -> None:
        judged = [metric for metric in self.result.global_metrics if metric.verdict is not None]
        self.user_properties += [(metric.metric, metric.value) for metric in judged]
        far = [_far(metric) for metric in judged if metric.verdict is not Verdict.AGREES]
        if far:
            raise SceneFailure("\n".join(far))


def told(observation: ObservationResult, scene: SceneResult) -> str:
    """How close it is known to be, the numbers behind that, and how to see it again."""
    lines = [sentence(observation, each) for each in observation.comparisons if each.verdict is observation.verdict]
    return "\n  ".join([observation.statement, *lines, *observation.unmeasured, f"again: {scene.reproduce}"])


def _far(metric: GlobalMetric) -> str:
    expected = metric.ideal if metric.floor is None else metric.floor
    return f"{metric.metric} is {metric.value:.5g} and would be {expected:.5g} by noise alone, +- {metric.tolerance}"
