"""Names in a scene file: each given once, and each used one given. Works on plain data, before there are types."""

from __future__ import annotations

from typing import Any

from vitrail.base.suggestion import suggestion
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.yaml_tree import Places


def name_diagnostics(data: dict[str, Any], places: Places, file: str) -> list[Diagnostic]:
    """Errors for materials that do not exist, and for names given twice among objects, lights or observations."""
    found = []
    for section, noun in (("objects", "object"), ("lights", "light"), ("observe", "observation")):
        found += _duplicates(data.get(section), section, noun, places, file)
    return found + _dangling_materials(data, places, file)


def _duplicates(entries: Any, section: str, noun: str, places: Places, file: str) -> list[Diagnostic]:
    seen: dict[str, int] = {}
    found = []
    for index, name in _field(entries, "name"):
        line, col = places.of(section, index, "name")
        if not name.strip():
            found.append(Diagnostic(file, line, col, f"the {noun} has an empty name", "give it a name"))
        elif name in seen:
            what = f"the {noun} `{name}` was already named in line {seen[name]}"
            found.append(Diagnostic(file, line, col, what, "give it another name"))
        else:
            seen[name] = line
    return found


def _dangling_materials(data: dict[str, Any], places: Places, file: str) -> list[Diagnostic]:
    materials = data.get("materials")
    known = list(materials) if isinstance(materials, dict) else []
    found = []
    for index, name in _field(data.get("objects"), "material"):
        if name not in known:
            line, col = places.of("objects", index, "material")
            remedy = suggestion(name, known, "material")
            found.append(Diagnostic(file, line, col, f"there is no material `{name}`", remedy))
    return found


def _field(entries: Any, key: str) -> list[tuple[int, str]]:
    """(index, text) of each entry of a list of mappings that has text under ``key``."""
    if not isinstance(entries, list):
        return []
    return [
        (index, entry[key])
        for index, entry in enumerate(entries)
        if isinstance(entry, dict) and isinstance(entry.get(key), str)
    ]
