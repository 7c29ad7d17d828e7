"""The name of a scene's content: equal for equal scenes, however their files are laid out."""

from __future__ import annotations

import hashlib

from vitrail.scene.model import Scene


def scene_hash(scene: Scene) -> str:
    """SHA-256 (hex) of the scene's values in canonical order."""
    return hashlib.sha256(scene.model_dump_json(by_alias=True, exclude_defaults=True).encode()).hexdigest()
