"""docs/closed-forms.md speaks of tests and scenes that exist, and of every single-ray test."""

from __future__ import annotations

import re

from ruamel.yaml import YAML

from tests.closed_forms.documented import ROOT, rows
from tests.closed_forms.test_single_rays import CASES, PROMISED
from vitrail.scene.model import Paper


def test_every_test_and_scene_of_the_table_exists():
    source = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests" / "tracer").glob("*.cc"))
    tests = {f"{suite}.{name}" for suite, name in re.findall(r"^TEST\((\w+), (\w+)\)", source, re.MULTILINE)}
    scenes = set(YAML(typ="safe").load((ROOT / "references" / "analytic.yaml").read_text())["scenes"])
    known = tests | {f"{scene}.yaml" for scene in scenes}
    for row in rows():
        assert row.ray or row.light, f"{row.case}: nothing shows it"
        assert set(row.light) <= known, f"{row.case}: {sorted(set(row.light) - known)}"


def test_every_single_ray_is_in_the_table_within_its_promise():
    assert {row.ray for row in rows()} - {None} == {case.__name__ for case in CASES}
    assert all(row.ray_error < PROMISED for row in rows())


def test_every_switch_of_the_paper_is_in_the_ledger_with_a_test_that_exists():
    section = (ROOT / "docs" / "errata.md").read_text(encoding="utf-8").split("### 1.7", 1)[1].split("\n## ", 1)[0]
    lines = [line for line in section.splitlines() if line.startswith("| ") and "`test_" in line]
    switches = set(re.findall(r"`(\w+)", " ".join(line.split("|")[2] for line in lines)))
    assert set(Paper.model_fields) <= switches
    tests = set(re.findall(r"^def (test_\w+)", (ROOT / "tests/closed_forms/test_errata.py").read_text(), re.MULTILINE))
    named = {re.search(r"`(test_\w+)`", line).group(1) for line in lines}
    assert named <= tests
    assert tests - named == {"test_povray_refuses_what_it_cannot_read_by_the_letter"}
