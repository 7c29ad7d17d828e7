"""The smallest defects that must be seen are seen at default quality, and half of one never passes for agreement."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from tests.end_to_end.conftest import ROOT
from vitrail.study.mutants.limits import LIMITS, is_kept, measure_limits

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

CALIBRATION = ROOT / "scenes" / "calibration"

DEAR = ("spread",)
"""POV-Ray takes 20 s for this scene; `vitrail mutants --limits` has it, and its numbers are in docs/studies."""


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One folder, so that POV-Ray draws each scene once."""
    return tmp_path_factory.mktemp("limits")


@pytest.mark.parametrize("limit", LIMITS, ids=lambda limit: limit.name)
def test_a_defect_deviates_half_of_it_never_agrees_and_none_of_it_does(limit, out: Path) -> None:
    against = () if limit.name in DEAR else ("povray",)
    found = measure_limits(CALIBRATION, out, limits=[limit], against=against)
    sides = Counter(side for row in found.rows for side in row.against)
    assert sides == {side: 3 for side in (*against, "truth")}, "a side without a number has seen nothing"
    assert found.kept, [row for row in found.rows if not is_kept(row)]
    # Half of a defect lies beyond what is allowed, so that no quieter picture can make it agree.
    halves = [entry for row in found.rows if row.share == 0.5 for entry in row.against.values()]
    assert all(abs(entry.difference) > entry.tolerance for entry in halves)
