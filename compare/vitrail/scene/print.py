"""A scene as canonical YAML: one text for each scene, which reads back as the same scene.

Settings at their defaults are left out, equal channels become one number, numbers are the shortest that read back
exactly. The hash of this text identifies a scene in images, caches and reports.
"""

from __future__ import annotations

import hashlib
import re
from typing import Any

from vitrail.scene.colours import colour_keys
from vitrail.scene.model import Part, Scene

_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*")
_WORDS_OF_YAML = {"true", "false", "null"}


def print_scene(scene: Scene) -> str:
    """Canonical YAML; ``load_text(print_scene(scene)).scene == scene``."""
    lines: list[str] = []
    for key, value in scene.entries():
        if isinstance(value, dict) and value:
            lines.append(f"{key}:")
            lines += [f"  {_text(name)}: {_flow(inner, '')}" for name, inner in value.items()]
        elif isinstance(value, tuple) and value:
            lines.append(f"{key}:")
            lines += [f"  - {_flow(inner, '')}" for inner in value]
        else:
            lines.append(f"{key}: {_flow(value, key)}")
    return "\n".join(lines) + "\n"


def scene_hash(scene: Scene) -> str:
    """SHA-256 of the canonical text, in hexadecimal."""
    return hashlib.sha256(print_scene(scene).encode("utf-8")).hexdigest()


def _flow(value: Any, key: str) -> str:
    """One value on one line."""
    match value:
        case Part():
            return "{" + ", ".join(f"{name}: {_flow(inner, name)}" for name, inner in value.entries()) + "}"
        case bool():
            return "true" if value else "false"
        case str():
            return _text(value)
        case int():
            return str(value)
        case float():
            return _number(value)
        case tuple() if key in colour_keys() and len(value) == 3 and value[0] == value[1] == value[2]:
            return _number(value[0])
        case tuple():
            inner_key = "color" if key == "colors" else ""
            return "[" + ", ".join(_flow(inner, inner_key) for inner in value) + "]"
        case dict() if not value:
            return "{}"
        case _:
            raise TypeError(f"a scene holds no {type(value).__name__}")


def _number(value: float) -> str:
    """The shortest decimal that reads back as the same number; whole numbers without a point."""
    if value == int(value) and abs(value) < 1e15:
        return str(int(value))
    return repr(value)


def _text(value: str) -> str:
    """Text as a plain word where YAML reads it back as text, in double quotes elsewhere."""
    if _PLAIN.fullmatch(value) and value.lower() not in _WORDS_OF_YAML:
        return str(value)
    return '"' + "".join(_escaped(character) for character in value) + '"'


def _escaped(character: str) -> str:
    if character in '"\\':
        return "\\" + character
    if character == " " or character.isprintable() and character != "\ufeff":
        return character
    code = ord(character)
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"
