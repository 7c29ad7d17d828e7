"""A program that was built again is another one, whatever version it states."""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.engines.engine_build import build_of
from vitrail.engines.tracer import Tracer

pytestmark = [pytest.mark.povray, pytest.mark.tracer]


def test_a_program_that_was_built_again_is_another_one(tmp_path: Path) -> None:
    program = tmp_path / "vitrail-tracer"
    builds = []
    for body in ("exit 0", "exit 0", "exit  0"):
        program.write_text(f"#!/bin/sh\n[ $1 = version ] && echo vitrail-tracer 0.1.0; {body}\n")
        program.chmod(0o755)
        builds.append(build_of(Tracer(program)))
    assert builds[0] == builds[1] != builds[2]
    assert all(build.startswith("vitrail-tracer 0.1.0 (") for build in builds)
