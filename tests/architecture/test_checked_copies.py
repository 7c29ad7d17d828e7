"""A value that has rules is never copied past them."""

from __future__ import annotations

import re
from pathlib import Path

from tests.architecture.source_tree import ROOT

PRODUCT = ROOT / "compare" / "vitrail"
BEYOND_THE_RULES = {
    "base/changed.py": "where it is defined",
    "geometry/shapes/axial.py": "a moved shape is as sound as before, up to rounding",
    "geometry/shapes/flat.py": "a moved shape is as sound as before, up to rounding",
    "geometry/shapes/sphere.py": "a moved shape is as sound as before, up to rounding",
    "geometry/shapes/torus.py": "a moved shape is as sound as before, up to rounding",
    "geometry/world.py": "ranks among solids go beyond the priorities that a file may give",
    "lower/povray/viewed.py": "the camera of a view is sound, and the rest may be spoilt on purpose",
    "plan/reduced.py": "what is taken away breaks no rule, and the rest may be spoilt on purpose",
    "study/mutants/misreadings.py": "a defect may break the rules of a scene",
}
"""Who makes a value without asking its type, and why."""


def users_of(pattern: str) -> set[str]:
    found = re.compile(pattern)
    files = PRODUCT.rglob("*.py")
    return {str(path.relative_to(PRODUCT)) for path in files if found.search(path.read_text(encoding="utf-8"))}


def test_no_copy_goes_past_the_checks_of_its_type() -> None:
    """``model_copy(update=...)`` takes a misspelt field and a negative radius without a word."""
    assert not users_of(r"model_copy\((?!\))"), "use vitrail.base.changed.changed"


def test_who_makes_a_value_unchecked_says_why() -> None:
    assert users_of(r"\bunchecked\(|model_construct\(") == set(BEYOND_THE_RULES)


def test_the_paths_are_real() -> None:
    assert all((PRODUCT / Path(path)).is_file() for path in BEYOND_THE_RULES)
