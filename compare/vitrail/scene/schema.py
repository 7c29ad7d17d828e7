"""The scene language as JSON Schema, for editors that complete and check while a scene is written.

``python -m vitrail.scene.schema`` writes ``scenes/schema.json``.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from vitrail.scene.model import Area, Light, Object, Scene
from vitrail.scene.model.by_key import OneByKey

SCHEMA_FILE = Path("scenes/schema.json")


def scene_schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a scene file. What needs two values to judge is left to ``check``."""
    schema = _without_null(Scene.model_json_schema(by_alias=True, mode="validation"))
    for part in (Object, Light, Area):
        _write_by_key(schema["$defs"][part.__name__], part)
    for part in (Object, Light):
        _require_one_of(schema["$defs"][part.__name__], part)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema, "title": "Vitrail scene"}


def schema_text() -> str:
    """The text of ``scenes/schema.json``."""
    return json.dumps(scene_schema(), indent=2, ensure_ascii=False) + "\n"


def _without_null(schema: Any) -> Any:
    """Drop the alternative ``null``: in a scene file a key is either given a value or left out."""
    if isinstance(schema, list):
        return [_without_null(inner) for inner in schema]
    if not isinstance(schema, dict):
        return schema
    made = {key: _without_null(inner) for key, inner in schema.items() if not (key == "default" and inner is None)}
    if {"type": "null"} in made.get("anyOf", []):
        made["anyOf"] = [choice for choice in made["anyOf"] if choice != {"type": "null"}]
        if len(made["anyOf"]) == 1:
            made |= made.pop("anyOf")[0]
    return made


def _write_by_key(definition: dict[str, Any], part: type[OneByKey]) -> None:
    """In the place of the field of several types, one key for each type."""
    properties: dict[str, Any] = {}
    for name, value in definition["properties"].items():
        by_key = {key: {"$ref": f"#/$defs/{kind.__name__}"} for key, kind in part.kinds().items()}
        properties |= by_key if name == part.chosen else {name: value}
    definition["properties"] = properties
    definition["required"] = [name for name in definition["required"] if name != part.chosen]
    if not definition["required"]:
        del definition["required"]


def _require_one_of(definition: dict[str, Any], part: type[OneByKey]) -> None:
    """Exactly one of the keys must be there."""
    definition["oneOf"] = [{"required": [key]} for key in part.kinds()]


if __name__ == "__main__":
    SCHEMA_FILE.write_text(schema_text(), encoding="utf-8")
