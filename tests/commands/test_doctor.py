"""What ``vitrail doctor`` says on this machine, and on one where things are missing."""

from __future__ import annotations

import json

import pytest

from tests.commands.command_line import run
from vitrail.engines import installation
from vitrail.engines.base import EngineFailure

pytestmark = [pytest.mark.browser, pytest.mark.povray, pytest.mark.tracer]


def test_every_part_is_named_with_its_version() -> None:
    done = run("doctor", "--json")
    found = json.loads(done.stdout)
    parts = {part["part"]: part for part in found["parts"]}
    assert {"vitrail-tracer", "POV-Ray", "Python", "Chromium", "isolation", "numpy", "pydantic"} <= set(parts)
    assert parts["POV-Ray"]["version"].startswith("3.") and parts["POV-Ray"]["place"].endswith("povray")
    assert done.exit_code == (0 if found["ready"] else 4)


def test_the_table_has_a_row_for_each_part() -> None:
    said = run("doctor").stdout
    for word in ("POV-Ray", "vitrail-tracer", "Chromium", "numpy"):
        assert word in said


def test_missing_engines_are_said_with_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "/nonexistent")
    found = {each.part: each for each in installation.findings()}
    assert not found["POV-Ray"].is_there and "apt-get install povray" in found["POV-Ray"].to_do
    assert not found["Chromium"].is_there and "chromium" in found["Chromium"].to_do


def test_a_tracer_that_is_not_built_is_said_with_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    def nowhere(self: object) -> str:
        raise EngineFailure("tracer", "the program is not built", "run `make build`")

    monkeypatch.setattr(installation.Tracer, "version", nowhere)
    found = {each.part: each for each in installation.findings()}
    assert not found["vitrail-tracer"].is_there and "make build" in found["vitrail-tracer"].to_do
