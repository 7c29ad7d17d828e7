"""The exit codes are what documentation and scripts know them as, and the tracer ends with the same."""

from __future__ import annotations

import re
from pathlib import Path

from vitrail.base.exit_code import ExitCode

ROOT = Path(__file__).parents[2]


def test_the_numbers_are_those_that_scripts_know() -> None:
    assert [*ExitCode] == [0, 1, 2, 3, 4, 5, 70, 129, 130, 131, 143]


def test_the_tracer_ends_with_the_same_codes() -> None:
    """The tracer judges nothing, so its 1 is any program's: it could not write, or met a limit."""
    header = (ROOT / "tracer" / "app" / "commands.h").read_text(encoding="utf-8")
    codes = {name: int(number) for name, number in re.findall(r"kExit(\w+) = (\d+)", header)}
    assert codes == {
        "Ok": ExitCode.AGREES,
        "Failure": 1,
        "BadInput": ExitCode.SCENE_ERROR,
        "Interrupted": ExitCode.INTERRUPTED,
    }
