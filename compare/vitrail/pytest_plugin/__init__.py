"""``pytest --vitrail scenes/``: scenes as test files, their observations as tests.

Each scene is rendered once, when its first test runs. What it is held against follows from what there is (``auto``):
closed forms always, the stored image where one was accepted, POV-Ray where it is installed. A deviation fails, and so
does doubt. The report of the session is written where ``--vitrail-out`` says.

This file is loaded by every session of an environment that has Vitrail, so it imports nothing until it is asked for.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from vitrail.pytest_plugin.items import SceneFile

SCENE_KEY = "vitrail:"


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("vitrail", "glass scenes in two engines")
    group.addoption("--vitrail", action="store_true", help="Collect scene files (.yaml) as tests.")
    group.addoption(
        "--vitrail-against",
        choices=("auto", "povray", "stored", "both"),
        default="auto",
        help="What the tracer is held against beside closed forms; auto takes what there is.",
    )
    group.addoption("--vitrail-quality", choices=("draft", "normal", "reference"), default="normal", help="Settings.")
    group.addoption("--vitrail-out", default="vitrail-report", help="The folder of report, results and images.")
    group.addoption("--vitrail-references", default="", help="The folder of closed forms, thresholds and images.")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> SceneFile | None:
    """A YAML file that says it is a scene; other YAML is none of ours."""
    if not parent.config.getoption("vitrail") or file_path.suffix != ".yaml":
        return None
    with file_path.open(encoding="utf-8", errors="replace") as file:
        if not any(line.startswith(SCENE_KEY) for line in file):
            return None
    from vitrail.pytest_plugin.items import SceneFile

    return SceneFile.from_parent(parent, path=file_path)


def pytest_collection_finish(session: pytest.Session) -> None:
    """Share the false-alarm rate among the tests that were selected."""
    if session.config.getoption("vitrail"):
        from vitrail.pytest_plugin.items import SceneTest
        from vitrail.pytest_plugin.session import of_session

        of_session(session.config).tests = sum(isinstance(item, SceneTest) for item in session.items)


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Write the report of what was rendered, and say where it is."""
    if not session.config.getoption("vitrail"):
        return
    from vitrail.pytest_plugin.session import of_session

    page = of_session(session.config).finish()
    reporter: Any = session.config.pluginmanager.get_plugin("terminalreporter")
    if page is not None and reporter is not None:
        reporter.ensure_newline()
        reporter.write_line(f"vitrail report: {page}")
