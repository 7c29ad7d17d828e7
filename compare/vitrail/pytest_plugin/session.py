"""What the tests of one session share: the scenes rendered so far, and the rate of false alarms among all tests."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import pytest

from vitrail.check.check import CheckResult
from vitrail.engines.base import EngineFailure
from vitrail.engines.povray import Povray
from vitrail.judge.records import SceneResult, write_results
from vitrail.judge.references import references_folder
from vitrail.judge.stored import IMAGE
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.compare import compare_scene
from vitrail.pipeline.judge import judge
from vitrail.pipeline.request import Request
from vitrail.pipeline.scene_run import SceneRun, SceneTask
from vitrail.report.build import build_report

NUMBERS_OF_ONE_OBSERVATION = 64
"""More comparisons than any observation makes. The level of an interval must be known before all scenes are measured,
so the false-alarm rate is shared among this many for each test; the rate that results is never above the stated one."""


@dataclass
class Session:
    """What the tests of one session share."""

    config: pytest.Config
    tests: int = 0
    runs: dict[Path, SceneRun] = field(default_factory=dict)

    @property
    def out(self) -> Path:
        """The folder of the report; a worker of a parallel session has its own."""
        worker = getattr(self.config, "workerinput", {}).get("workerid", "")
        return Path(self.config.getoption("vitrail_out")) / worker

    def result(self, loaded: CheckResult, path: Path) -> SceneResult:
        """The judged scene, rendered when it is first asked for."""
        if path not in self.runs:
            self.runs[path] = self._run(loaded, path)
        planned = max(self.tests, 1) * NUMBERS_OF_ONE_OBSERVATION
        return judge([self.runs[path]], about_run(()), comparisons=planned).scenes[0]

    def _run(self, loaded: CheckResult, path: Path) -> SceneRun:
        given = self.config.getoption("vitrail_references")
        request = Request(
            out=self.out,
            quality=self.config.getoption("vitrail_quality"),
            references=Path(given) if given else None,
            against=self._against(path, references_folder(path, Path(given) if given else None)),
        )
        request.out.mkdir(parents=True, exist_ok=True)
        return compare_scene(SceneTask(path.stem, loaded.scene_or_raise(), request))

    def _against(self, path: Path, folder: Path) -> tuple[str, ...]:
        """What the scene is held against; ``auto`` takes what there is."""
        wish = self.config.getoption("vitrail_against")
        if wish != "auto":
            return ("povray", "stored") if wish == "both" else (wish,)
        found = ("stored",) if (folder / path.stem / IMAGE).is_file() else ()
        return (*found, "povray") if _has_povray() else found

    def finish(self) -> Path | None:
        """Write results and report of everything that was rendered."""
        if not self.runs:
            return None
        planned = max(self.tests, 1) * NUMBERS_OF_ONE_OBSERVATION
        write_results(judge(list(self.runs.values()), about_run(()), comparisons=planned), self.out / "results.json")
        return build_report(self.out)


SESSION = pytest.StashKey[Session]()


def of_session(config: pytest.Config) -> Session:
    """The session's shared state, made when it is first asked for."""
    if SESSION not in config.stash:
        config.stash[SESSION] = Session(config)
    return config.stash[SESSION]


def _has_povray() -> bool:
    try:
        Povray().version()
    except EngineFailure:
        return False
    return True
