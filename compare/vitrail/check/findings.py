"""Where the checks of a loaded scene put what they find."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.world import World
from vitrail.scene.diagnostic import Diagnostic, Severity
from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene


@dataclass
class Findings:
    """Diagnostics about one loaded scene; a path leads to the value that each is about."""

    loaded: Loaded
    diagnostics: list[Diagnostic] = field(default_factory=list)
    _broken: set[int] = field(default_factory=set)

    @property
    def scene(self) -> Scene:
        return self.loaded.scene

    @cached_property
    def world(self) -> World:
        """The scene in space, its meshes where they can be read."""
        return World.of(self.loaded)

    @cached_property
    def world_without_meshes(self) -> World:
        """The scene with its meshes unread: what one that is not closed holds, or hides, means nothing."""
        if not any(isinstance(solid, PlacedMesh) for solid in self.world.solids):
            return self.world
        return World.of_scene(self.scene)

    @property
    def broken_objects(self) -> set[int]:
        """Indices of the objects that have an error already, and whose geometry means nothing."""
        return self._broken

    def error(self, what: str, remedy: str, *path: str | int) -> None:
        if path[0] == "objects" and len(path) > 1 and isinstance(path[1], int):
            self._broken.add(path[1])
        self._add(Severity.ERROR, what, remedy, path)

    def warning(self, what: str, remedy: str, *path: str | int) -> None:
        self._add(Severity.WARNING, what, remedy, path)

    def _add(self, severity: Severity, what: str, remedy: str, path: tuple[str | int, ...]) -> None:
        line, col = self.loaded.places.of(*path)
        self.diagnostics.append(Diagnostic(str(self.loaded.path), line, col, what, remedy, severity))
