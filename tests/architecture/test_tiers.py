"""The guard of the tiers: what a test starts, and whether its markers say so."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests import tiers


@pytest.mark.parametrize(
    ("program", "arguments", "tier"),
    [
        ("unshare", ["unshare", "--net", "setpriv", "/usr/bin/povray", "+Ia.pov"], "povray"),
        ("/x/build/release/tracer/vitrail-tracer", ["vitrail-tracer", "--version"], "tracer"),
        ("/usr/bin/chromium", ["chromium", "--version"], "browser"),
        (sys.executable, [sys.executable, "-c", "pass"], "slow"),
        (".venv/bin/vitrail", ["vitrail", "check"], "slow"),
        ("git", ["git", "ls-files"], None),
    ],
)
def test_a_program_belongs_to_its_tier(program: str, arguments: list[str], tier: str | None) -> None:
    assert tiers.needed_tier(program, arguments) == tier


def test_a_fast_test_may_not_start_another_python() -> None:
    with pytest.raises(RuntimeError, match="mark its module with pytest.mark.slow"):
        subprocess.run([sys.executable, "-c", "pass"], check=False)


def test_this_test_is_fast(request: pytest.FixtureRequest) -> None:
    assert request.node.get_closest_marker("fast") is not None
