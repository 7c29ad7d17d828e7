"""A scene as things in space: made once from what was loaded, and handed on to check, plan and back ends."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene


@dataclass(frozen=True, eq=False)
class World:
    """The geometry of one scene.

    ``folder`` is where the files that the scene names are sought; without it they stay as named and are not read.
    ``loaded`` holds the lines of the file, for messages; a scene made in memory has none.
    """

    scene: Scene
    folder: Path | None = None
    loaded: Loaded | None = None

    @classmethod
    def of(cls, loaded: Loaded) -> World:
        """The world of a scene file."""
        return cls(loaded.scene, loaded.path.parent, loaded)

    @classmethod
    def of_scene(cls, scene: Scene, folder: Path | None = None) -> World:
        """The world of a scene that was made in memory."""
        return cls(scene, folder)

    def with_scene(self, scene: Scene) -> World:
        """The world of a changed scene, with the same folder and the same lines for messages."""
        return replace(self, scene=scene)
