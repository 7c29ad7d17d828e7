"""One home for each fact: what is written twice is one day changed once."""

from __future__ import annotations

import re

import pytest

from tests.architecture.source_tree import PACKAGE

FACTS = {
    "the lines of Fraunhofer": (r"486\.1|587\.5|656\.2", {"optics/lines.py"}),
    "the paper's band shift": (r'"d_line": 1', {"optics/dispersion.py"}),
    "the exit codes": (r"(?m)(?:=|\() ?(?:129|130|131|143)\)?$", {"base/exit_code.py"}),
    "files that appear whole": (r"token_hex|mkstemp", {"base/scratch.py"}),
    "canonical JSON": (r"separators=\(", {"base/canonical_json.py"}),
    "the camera's axes": (r"cross\(right, forward\)", {"geometry/camera.py"}),
    "the keys of shapes and lights": (r'"rectangle", "disc"', set()),
}
"""What is looked for, and the only files that may hold it."""


@pytest.mark.parametrize(("pattern", "homes"), FACTS.values(), ids=FACTS)
def test_a_fact_is_written_in_one_place(pattern: str, homes: set[str]) -> None:
    found = {
        str(path.relative_to(PACKAGE))
        for path in PACKAGE.rglob("*.py")
        if re.search(pattern, path.read_text(encoding="utf-8"))
    }
    assert found <= homes, f"also in {sorted(found - homes)}; use {sorted(homes) or 'the types'}"
    assert homes <= found, f"not in {sorted(homes - found)} any more; mend this list"
