"""A few of the kills that docs/reliability.md counts."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.fuzz.kills import kill_often

pytestmark = pytest.mark.slow


def test_a_render_that_was_killed_is_made_again_with_the_same_bytes(tmp_path: Path) -> None:
    assert kill_often(4, 1, tmp_path) == []
