"""One vocabulary: a phenomenon has one name in the scene, the tracer, every schema, the thresholds and the glossary."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

from ruamel.yaml import YAML

from tests.architecture.source_tree import ROOT, TRACER, cpp_files
from vitrail.base.phenomenon import Phenomenon

NAMES = [phenomenon.value for phenomenon in Phenomenon]


def enumerations(node: Any) -> Iterator[list[Any]]:
    """Every ``enum`` list anywhere in a JSON Schema."""
    if isinstance(node, dict):
        if isinstance(node.get("enum"), list):
            yield node["enum"]
        for child in node.values():
            yield from enumerations(child)
    elif isinstance(node, list):
        for child in node:
            yield from enumerations(child)


def test_the_tracer_knows_the_same_phenomena_in_the_same_order() -> None:
    """A list of string literals with three or more phenomena in it is about phenomena; one of them is complete."""
    lists = []
    for path in cpp_files():
        for block in re.findall(r"\{([^{}]*)\}", path.read_text(encoding="utf-8")):
            words = re.findall(r'"([a-z_]+)"', block)
            if len(set(words) & set(NAMES)) >= 3:
                lists.append((path.relative_to(TRACER), words))
    for path, words in lists:
        assert words == [name for name in NAMES if name in words], (
            f"{path} lists what is no phenomenon, or out of order"
        )
    assert NAMES in [words for _, words in lists], "no list under tracer/ has every phenomenon of base/phenomenon.py"


def test_the_schemas_list_the_same_phenomena() -> None:
    for name in ("scenes/schema.json", "references/results.schema.json"):
        schema = json.loads((ROOT / name).read_text(encoding="utf-8"))
        lists = [values for values in enumerations(schema) if NAMES[0] in values]
        assert lists, f"{name} names no phenomena"
        for values in lists:
            assert values == NAMES, f"{name} lists other phenomena"


def test_thresholds_are_about_phenomena() -> None:
    """Every key of thresholds.yaml under ``phenomena`` is in the vocabulary."""
    thresholds = YAML(typ="safe").load((ROOT / "references" / "thresholds.yaml").read_text(encoding="utf-8"))
    assert set(thresholds["phenomena"]) <= set(NAMES)


def test_every_phenomenon_is_in_the_glossary() -> None:
    glossary = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")
    missing = [name for name in NAMES if f"**{name}**" not in glossary]
    assert not missing, f"docs/glossary.md says nothing about {missing}"


def test_glossary_phenomena_exist() -> None:
    glossary = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")
    section = glossary.split("## Phenomena", 1)[1].split("\n## ", 1)[0]
    assert re.findall(r"^\*\*([a-z_]+)\*\*", section, re.MULTILINE) == NAMES
